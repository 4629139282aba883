// `normal {}` may be written without a pattern, to be completed by a later one (`#default { normal { bump_size 2 } }`); an object
// of the scene must not end up with such a normal (specification chapter 11 §10.1; measured: POV-Ray complains at the end of the
// top-level object, not where the normal is written).
#pragma once

#include "engine/scene/object.hpp"

namespace lute {

// Some part of the object, or the object, has a normal without pattern. Parts without texture have `default_texture`.
bool has_untyped_normal(const Object& object, const Texture& default_texture);

}  // namespace lute
