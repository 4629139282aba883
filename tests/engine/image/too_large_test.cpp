// Files whose headers promise more pixels than they can have, for which nothing is allocated, and those that promise as many as they can.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/image/image_file.hpp"

namespace lute::test {
namespace {

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255u);
  return bytes;
}

// A chunk of PNG with its checksum.
std::string png_chunk(const std::string& name, const std::string& data) {
  const std::string content = name + data;
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + content + big_endian(static_cast<std::uint32_t>(crc));
}

std::string png_header(std::uint32_t side, char depth, char color_type) {
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", big_endian(side) + big_endian(side) + depth + color_type + std::string(3, '\0'));
}

// A file of zeros, as small as deflate makes it.
std::string png_of_zeros(std::uint32_t side, char depth, char color_type, std::size_t channels, const std::string& chunks) {
  const std::size_t row = 1 + (side * channels * static_cast<std::size_t>(depth) + 7) / 8;
  const std::string pixels(row * side, '\0');
  uLongf size = compressBound(pixels.size());
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(pixels.data()), pixels.size(), 9);
  packed.resize(size);
  return png_header(side, depth, color_type) + chunks + png_chunk("IDAT", packed) + png_chunk("IEND", "");
}

class ImageSize : public testing::Test {
 protected:
  ~ImageSize() override { std::filesystem::remove(path_); }
  ImagePtr load(const char* suffix, const std::string& bytes) {
    path_ = std::filesystem::path(testing::TempDir()) /
            (std::string("lute_") + testing::UnitTest::GetInstance()->current_test_info()->name() + suffix);
    std::ofstream(path_, std::ios::binary) << bytes;
    ImageFiles files;
    return files.load(path_.string(), ImageFileOptions(), error_);
  }
  std::filesystem::path path_;
  std::string error_;
};

TEST_F(ImageSize, OfMoreThanAPngCanHoldIsAnError) {
  EXPECT_EQ(load(".png", png_header(1'000'000, 16, 6) + big_endian(1) + "IDAT"), nullptr);  // 8 bytes a pixel: 8 TB
  EXPECT_EQ(error_, "Cannot read PNG image '" + path_.string() + "': it is too short for its size.");
}

// Deflate makes a thousandth of these: no less may be taken for broken.
TEST_F(ImageSize, OfPlainPngsOfFewBitsIsRead) {
  const std::string palette = png_chunk("PLTE", std::string("\xff\x80\0\0\0\0", 6)), clear = png_chunk("tRNS", std::string(6, '\0'));
  for (const std::string& file : {png_of_zeros(4000, 1, 0, 1, ""), png_of_zeros(4000, 1, 3, 1, palette), png_of_zeros(2000, 8, 2, 3, clear)}) {
    const auto image = load(".png", file);
    ASSERT_NE(image, nullptr) << error_;
    EXPECT_GE(image->width(), 2000);
  }
}

// The header and the beginning of a picture of 65535 x 65535 pixels, whose data ends at once.
TEST_F(ImageSize, OfAShortGifTakesNoMemory) {
  const std::string gif = std::string("GIF89a\xff\xff\xff\xff\x80\0\0", 13) + std::string("\0\0\0\xff\xff\xff", 6) +
                          std::string(",\0\0\0\0\xff\xff\xff\xff\0\2\2\x4c\1\0;", 16);
  const std::size_t before = peak_memory();
  EXPECT_EQ(load(".gif", gif), nullptr);
  EXPECT_NE(error_.find("Cannot read GIF image"), std::string::npos) << error_;
  EXPECT_LT(peak_memory() - before, std::size_t{100} << 20);  // the picture has 4 GB
}

}  // namespace
}  // namespace lute::test
