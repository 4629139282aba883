// The library of image formats (OpenImageIO), loaded when the first image is read or written.
//
// OpenImageIO brings some 250 shared libraries along: loading them takes 0.3 s, several times what a small picture takes to render. So
// only one module, `lute_openimageio`, is linked with it, and that module is opened on first use. PNG files, by far the most
// common output, are written without it (engine/output). This header speaks of pixels only, never of OpenImageIO.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lute {

enum class ChannelType : std::uint8_t { kUint8, kUint16, kHalf, kFloat };

// Pixels row by row from the top, channels interleaved (Y, YA, RGB or RGBA), as floats: integers scaled to 0...1.
struct ImagePixels {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;  // width * height * channels
};

// What a file says about its pixels. Nothing is converted: gamma and alpha are the caller's business.
struct ImageFileInfo {
  ChannelType stored = ChannelType::kUint8;
  std::string format;             // "png", "jpeg", "tiff", ...
  bool srgb = false;              // the file declares sRGB
  double gamma = 0;               // the file declares a power curve (1 / gAMA); 0: it does not
  bool has_alpha = false;         // the last channel is alpha, by the file's word
  bool alpha_premultiplied = false;
};

struct WriteOptions {
  std::string format;             // OpenImageIO's name: "openexr", "hdr", "pnm" (8 bits only), "targa", "bmp", "jpeg", "tiff"
  ChannelType type = ChannelType::kUint8;
  int jpeg_quality = 85;
  bool rle = false;               // Targa
};

class FormatLibrary {
 public:
  virtual ~FormatLibrary() = default;

  // On failure `error` says why and the result is false.
  virtual bool read(const std::string& path, ImagePixels& pixels, ImageFileInfo& info, std::string& error) const = 0;
  // A file whose content is `bytes`; its path says the format only.
  virtual bool read(const std::string& path, std::span<const std::uint8_t> bytes, ImagePixels& pixels, ImageFileInfo& info,
                    std::string& error) const = 0;
  // Values are stored as they are (integers: rounded from 0...1). The file is complete or, on failure, of no use.
  virtual bool write(const std::string& path, const ImagePixels& pixels, const WriteOptions& options, std::string& error) const = 0;
};

// Opens the module on the first call. Null, with `error` set, when it cannot be found beside the program.
const FormatLibrary* format_library(std::string& error);

}  // namespace lute
