// interior { ... }, media { ... } and material { ... } (specification chapter 11 §5.4, §11, §12).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword. `base` null: a new interior; else it is edited, unless the block names another.
InteriorPtr parse_interior(Reader& reader, const InteriorPtr& base);

MediaPtr parse_media(Reader& reader);

// `{ ... }` after the keyword: adds to what the object has. With `uv_mapping` textures do not move.
void parse_material(Reader& reader, Material& material, bool uv_mapping);

// The media of an interior, moved. Null stays null.
InteriorPtr moved(const InteriorPtr& interior, const Transform& transform);

}  // namespace lute
