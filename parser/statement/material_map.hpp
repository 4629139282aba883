// texture { material_map { IMAGE ... texture {...} ... } } (specification chapter 11 §9.2).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword.
void parse_material_map(Reader& reader, Texture& texture);

}  // namespace lute
