// Image files and function images in scene text, and image_map, bump_map, image_pattern, material_map (specification chapters 11
// §10.4 and 50 §11).
#pragma once

#include "engine/image/image.hpp"
#include "engine/texture/image_mapping.hpp"
#include "parser/reader.hpp"

namespace lute {

enum class ImageUse : std::uint8_t { kColors, kValues, kHeights };

// [VECTOR] (TYPE "file" | "file" | function W, H {...}) {gamma ... | premultiplied ...}
ImagePtr parse_image(Reader& reader, ImageUse use);

// once, map_type, interpolate, repeat, offset; false if none of them comes next. `checked`: values outside the known ones are errors.
bool accept_mapping_item(Reader& reader, ImageMapping& mapping, bool checked);

}  // namespace lute
