// The box of an object as min_extent and max_extent tell it: POV-Ray's, which grows with every rotation, where the renderer's own is
// as tight as it can be. Scenes place things by these numbers. Source: specification chapter 20 §7.3.
#pragma once

#include <functional>

#include "engine/math/aabb.hpp"
#include "engine/scene/object.hpp"

namespace lute {

// `tight_box` gives the renderer's box of an object; it is asked for what has no rule of its own here.
Aabb language_extent(const Object& object, const std::function<Aabb(const Object&)>& tight_box);

}  // namespace lute
