// What every object takes after its own items: transformations, textures, clips, flags (specification chapter 11 §8).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// All modifiers up to the end of the block and the final checks; the brace is left.
void parse_object_modifiers(Reader& reader, Object& object);

}  // namespace lute
