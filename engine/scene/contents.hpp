// How deep descriptions are inside each other and how many parts they have, found from what their parts know of themselves: whoever
// makes a description keeps its depth or Contents in it.
#pragma once

#include "engine/scene/object.hpp"

namespace lute {

// Of what a pattern asks: another pigment, a function, an object; 0: nothing.
std::uint32_t depth_of(const PatternBody& body);

// Found from the parts; to be kept in the value's own `depth`.
std::uint32_t depth_of(const Pigment& pigment);
std::uint32_t depth_of(const Normal& normal);
std::uint32_t depth_of(const Texture& texture);

Contents contents_of(const Object& object);

// Whether the object has no inside: triangles and other patches, lights that look like nothing or like a patch, and what is made with any
// of them, except a light_group.
bool is_patch(const Object& object);

Contents contents_of(const std::vector<ObjectPtr>& objects);

}  // namespace lute
