// Truevision Targa files: colour-mapped, true colour or grey, plain or run-length encoded.
//
// The library of formats is asked only for what is rare (indices of two bytes): it hides palettes and the alpha of 16-bit pixels. As the
// reference has it (measured with 3.7.0.10): five bits count as eight whose lower three are 0; the highest bit of 16 is the pixel's opacity,
// and a fourth byte its alpha, in palettes too, whatever the header says of attribute bits; a picture stored from right to left comes
// out mirrored. Unlike there, packets may go on into the next row, as files of version 1 of the format have it, and grey pixels of
// 16 bits are grey and alpha: the reference makes garbage of both.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/image/image.hpp"

namespace lute {

struct TgaContent {
  int width = 0, height = 0;
  int channels = 1;                   // 1 to 4; of a palette image 1: indices
  std::vector<std::uint8_t> bytes;    // rows from the top
  std::vector<Image::Pixel> palette;  // values as stored / 255
};

// False when the file cannot be read: `error` set, or empty if it is of a kind that is left to the library of formats.
bool read_tga(const std::string& path, TgaContent& content, std::string& error);

}  // namespace lute
