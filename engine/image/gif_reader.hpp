// GIF files as stored, with their palette, which the library of formats hides: a height field and a material map go by the index of a
// pixel, not by its colour. Also POT, the height files of FractInt: a GIF twice as wide as the picture, whose left half holds the high
// bytes of the heights and whose right half holds the low ones.
// Only the first picture of an animation counts, on a ground of index 0. A transparent index has alpha 0.
// Source: CompuServe, Graphics Interchange Format, version 89a, 1990.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/image/image.hpp"

namespace lute {

struct GifContent {
  int width = 0, height = 0;
  std::vector<std::uint8_t> indices;  // below the size of the palette
  std::vector<Image::Pixel> palette;  // values as stored / 255, alpha 0 or 1
};

// False, with `error` set, when the file cannot be read.
bool read_gif(const std::string& path, GifContent& content, std::string& error);

}  // namespace lute
