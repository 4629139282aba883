// The inside of texture { ... } in versions below 3.0: pigment, normal and finish items stand directly in the texture
// (specification chapter 11 §9.3).
#pragma once

#include "parser/reader.hpp"

namespace lute {

TexturePtr parse_old_texture_items(Reader& reader);

}  // namespace lute
