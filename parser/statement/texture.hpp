// texture { ... } (specification chapter 11 §9.2, and §9.3 for versions below 3.0).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword: one texture, which has several layers where it names such a texture.
TexturePtr parse_texture(Reader& reader);
TexturePtr parse_interior_texture(Reader& reader);

// The inside of the block, as texture_map entries have it.
TexturePtr parse_texture_items(Reader& reader);

// All `texture { ... }` that follow each other, as layers; the first keyword is next. For #declare.
TexturePtr parse_texture_layers(Reader& reader);

// pigment {}, normal {}, finish {} directly in an object, material or blob component: the top layer changes in place.
// False if none of them comes next.
bool accept_layer_item(Reader& reader, TextureOnObject& on_object);

}  // namespace lute
