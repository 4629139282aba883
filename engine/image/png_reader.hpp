// PNG files as stored, without OpenImageIO: it is the most common input, and the library of formats hides palettes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/image/image.hpp"

namespace lute {

struct PngContent {
  int width = 0, height = 0;
  int channels = 1;             // 1 to 4; of a palette image 1: indices
  bool deep = false;            // 16 bits a sample
  bool grey_file = false;       // stored as grey without an alpha channel, at most 8 bits (tRNS may still give alpha)
  bool srgb = false;            // has an sRGB chunk
  double gamma = 0;             // gAMA, 0 if absent
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;
  std::vector<Image::Pixel> palette;  // values as stored / 255
};

// False, with `error` set, when the file cannot be read.
bool read_png(const std::string& path, PngContent& content, std::string& error);

}  // namespace lute
