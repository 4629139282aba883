// From the film to the numbers that a file stores: alpha, gamma, dithering, rounding. Source: specification chapter 30
// §7.4-7.7.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/image/format_library.hpp"
#include "engine/output/output_settings.hpp"
#include "engine/render/film.hpp"

namespace lute {

// Rows from the top, channels interleaved: Y, YA, RGB or RGBA, alpha not premultiplied.
struct EncodedImage {
  int width = 0, height = 0, channels = 0;
  int max = 255;  // the code of full intensity
  std::vector<std::uint16_t> codes;
};

// For formats of whole numbers.
EncodedImage encode(const Film& film, const Transfer& transfer, const OutputSettings& settings);

// Whether it looks codes up in a table of the curve: that is worth its making for large pictures.
bool encodes_by_table(const OutputSettings& settings, int width, int height);

// For OpenEXR and Radiance: linear light, alpha premultiplied and as it is.
ImagePixels linear_light(const Film& film, const Transfer& transfer, const OutputSettings& settings);

}  // namespace lute
