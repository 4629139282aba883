// Files whose headers promise more pixels than they can have: nothing is allocated for these.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "engine/image/image_file.hpp"

namespace lute::test {
namespace {

// A header of 16 bits, four channels, with the checksum of PNG, and the beginning of data.
std::string png_header(unsigned side) {
  const auto big_endian = [](unsigned value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255u);
    return bytes;
  };
  const std::string chunk = "IHDR" + big_endian(side) + big_endian(side) + std::string("\x10\x06\0\0\0", 5);
  unsigned crc = ~0u;
  for (const char c : chunk) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xEDB88320u : 0u);
  }
  return "\x89PNG\r\n\x1a\n" + big_endian(13) + chunk + big_endian(~crc) + big_endian(1) + "IDAT";
}

TEST(ImageTooLarge, IsAnErrorOfItsFile) {
  const auto path = std::filesystem::path(testing::TempDir()) / "lute_image_too_large.png";
  std::ofstream(path, std::ios::binary) << png_header(1'000'000);  // 8 bytes a pixel: 8 TB
  ImageFiles files;
  std::string error;
  EXPECT_EQ(files.load(path.string(), ImageFileOptions(), error), nullptr);
  EXPECT_EQ(error, "Cannot read PNG image '" + path.string() + "': it is too short for its size.");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace lute::test
