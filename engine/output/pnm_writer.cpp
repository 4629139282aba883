#include "engine/output/pnm_writer.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace lute {

void write_pnm(const std::string& path, const EncodedImage& image) {
  std::ofstream file(path, std::ios::binary);
  file << (image.channels == 1 ? "P5" : "P6") << "\n# lute\n"
       << image.width << ' ' << image.height << '\n'
       << image.max << '\n';
  std::string bytes;
  bytes.reserve(image.codes.size() * (image.max > 255 ? 2 : 1));
  for (const std::uint16_t code : image.codes) {
    if (image.max > 255) bytes.push_back(static_cast<char>(code >> 8));
    bytes.push_back(static_cast<char>(code & 255));
  }
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error(std::strerror(errno));
}

}  // namespace lute
