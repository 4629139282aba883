#include "engine/output/output_settings.hpp"

#include <array>

namespace lute {

const FormatTraits& traits_of(FileFormat format) {
  // In the order of FileFormat.
  static constexpr std::array<FormatTraits, 8> kFormats{{
      {FileFormat::kPng, 'N', ".png", true, true, false, true},
      {FileFormat::kTarga, 'T', ".tga", true, false, false, true},
      {FileFormat::kTargaRle, 'C', ".tga", true, false, false, true},
      {FileFormat::kBmp, 'B', ".bmp", true, false, false, true},
      {FileFormat::kPpm, 'P', ".ppm", false, true, false, true},
      {FileFormat::kJpeg, 'J', ".jpg", false, false, false, true},
      {FileFormat::kOpenExr, 'E', ".exr", true, true, true, false},
      {FileFormat::kRadianceHdr, 'H', ".hdr", false, false, true, true},
  }};
  return kFormats[static_cast<std::size_t>(format)];
}

}  // namespace lute
