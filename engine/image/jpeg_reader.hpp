// JPEG files, without OpenImageIO: height fields and image maps often come as JPEG, and loading the library of formats takes longer
// than a small picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lute {

struct JpegContent {
  int width = 0, height = 0;
  int channels = 3;  // 1: grey, 3: colours
  std::vector<std::uint8_t> bytes;
};

// False, with `error` set, when the file cannot be read. Files of four colour components (CMYK) are read as RGB.
bool read_jpeg(const std::string& path, JpegContent& content, std::string& error);

}  // namespace lute
