// How a picture is written: file format, bits, alpha, gamma, dithering. Source: specification chapter 30 §7.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/output/dither.hpp"
#include "engine/output/gamma.hpp"

namespace lute {

enum class FileFormat : std::uint8_t { kPng, kTarga, kTargaRle, kBmp, kPpm, kJpeg, kOpenExr, kRadianceHdr };

struct OutputSettings {
  FileFormat format = FileFormat::kPng;
  int bits = 8;            // of a channel, 5...16: PNG, and above 8 also PPM; the other formats have their own
  bool alpha = false;      // ignored where the format has none
  bool greyscale = false;  // PNG (16 bits) and PPM (becomes PGM)
  DitherMethod dither = DitherMethod::kNone;  // not for JPEG, OpenEXR, Radiance
  GammaCurve file_gamma{};                    // default sRGB
  GammaCurve display_gamma{};                 // counts only where a scene does not handle gamma
  int compression = 0;                        // JPEG quality 2...100; 0 or 1: 85
};

// What a format can do, one row each.
struct FormatTraits {
  FileFormat format;
  char letter;                 // of Output_File_Type
  std::string_view extension;  // with the dot
  bool has_alpha;
  bool has_greyscale;
  bool linear_light;  // stores floats
  bool to_stream;     // may be written to standard output
};
const FormatTraits& traits_of(FileFormat format);

}  // namespace lute
