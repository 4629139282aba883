#include "engine/image/color_mapped.hpp"
#include "tests/temporary_path.hpp"

#include <gif_lib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lute {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

class ColorMappedFile : public testing::Test {
 protected:
  ~ColorMappedFile() override { std::filesystem::remove(path_); }

  const std::string& write(const Bytes& bytes) {
    std::ofstream(path_, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path_;
  }
  void write_gif(int width, int height, const Bytes& pixels, bool interlaced) {
    int code = 0;
    GifFileType* file = EGifOpenFileName(path_.c_str(), false, &code);
    ASSERT_NE(file, nullptr);
    const GifColorType colors[4] = {{0, 0, 0}, {255, 0, 0}, {0, 51, 0}, {0, 0, 102}};
    ColorMapObject* map = GifMakeMapObject(4, colors);
    EGifPutScreenDesc(file, width, height, 2, 0, map);
    EGifPutImageDesc(file, 0, 0, width, height, interlaced, nullptr);
    for (int row = 0; row < height; ++row) {
      Bytes line(pixels.begin() + row * width, pixels.begin() + (row + 1) * width);
      EGifPutLine(file, line.data(), width);
    }
    EGifCloseFile(file, &code);
    GifFreeMapObject(map);
  }

  const std::string path_ = temporary_path("color_mapped");
  std::string error_;
};

void append(Bytes& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(std::uint64_t{value} >> (8 * i)));
}

// Three colours: 10·k, 20·k, 30·k for k = 0...2.
Bytes bmp(int bits, int width, int height, std::uint32_t compression, const Bytes& pixels) {
  Bytes file = {'B', 'M'};
  append(file, 0, 8);
  append(file, 14 + 40 + 12, 4);
  append(file, 40, 4);
  append(file, static_cast<std::uint32_t>(width), 4);
  append(file, static_cast<std::uint32_t>(height), 4);
  append(file, 1, 2);
  append(file, static_cast<std::uint32_t>(bits), 2);
  append(file, compression, 4);
  append(file, 0, 12);
  append(file, 3, 4);
  append(file, 0, 4);
  for (std::uint8_t k = 0; k < 3; ++k) file.insert(file.end(), {static_cast<std::uint8_t>(30 * k), static_cast<std::uint8_t>(20 * k), static_cast<std::uint8_t>(10 * k), 0});
  file.insert(file.end(), pixels.begin(), pixels.end());
  return file;
}

TEST_F(ColorMappedFile, GifKeepsIndicesAndColors) {
  write_gif(3, 2, {0, 1, 2, 3, 2, 1}, false);
  const auto image = read_gif(path_, error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_EQ(image->width, 3);
  EXPECT_THAT(image->indices, ElementsAre(0, 1, 2, 3, 2, 1));
  EXPECT_FLOAT_EQ(image->palette[2].rgb.g, 0.2f);  // 51/255
  EXPECT_FLOAT_EQ(image->palette[3].rgb.b, 0.4f);
}

// Measured with POV-Ray 3.7.0.10: an interlaced picture of 8 rows comes out with its rows as stored.
TEST_F(ColorMappedFile, InterlacedGifKeepsTheOrderOfItsFile) {
  write_gif(3, 2, {0, 1, 2, 3, 2, 1}, true);
  const auto image = read_gif(path_, error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(0, 1, 2, 3, 2, 1));
}

TEST_F(ColorMappedFile, GifCutAtAnyByteIsRefusedOrWhole) {
  write_gif(3, 2, {0, 1, 2, 3, 2, 1}, false);
  std::ifstream stream(path_, std::ios::binary);
  const Bytes whole(std::istreambuf_iterator<char>(stream), {});
  int refused = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    error_.clear();
    const auto image = read_gif(write({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), error_);
    EXPECT_NE(image.has_value(), !error_.empty()) << length;
    refused += image ? 0 : 1;
  }
  EXPECT_GT(refused, 20);  // header, screen, palette and the picture's head are 32 bytes
}

TEST_F(ColorMappedFile, GifWithAnyByteWrongIsRefusedOrConsistent) {
  write_gif(3, 2, {0, 1, 2, 3, 2, 1}, false);
  std::ifstream stream(path_, std::ios::binary);
  const Bytes whole(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int value : {0, 1, 0x2c, 0x7f, 0xff}) {
      Bytes bytes = whole;
      bytes[at] = static_cast<std::uint8_t>(value);
      const auto image = read_gif(write(bytes), error_);
      if (!image) continue;
      for (const std::uint8_t index : image->indices) EXPECT_LT(index, image->palette.size()) << at << ' ' << value;
    }
  }
}

TEST_F(ColorMappedFile, BmpRowsRunUpwardAndFillWholeWords) {
  const auto image = read_color_mapped_bmp(write(bmp(8, 3, 2, 0, {0, 1, 2, 99, 2, 1, 0, 99})), error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(2, 1, 0, 0, 1, 2));
  EXPECT_FLOAT_EQ(image->palette[1].rgb.r, 10 / 255.0f);
  EXPECT_FLOAT_EQ(image->palette[1].rgb.b, 30 / 255.0f);
}

TEST_F(ColorMappedFile, BmpPacksFourBits) {
  const auto image = read_color_mapped_bmp(write(bmp(4, 3, 1, 0, {0x12, 0x00, 0, 0})), error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(1, 2, 0));
}

// 1010 0000, 01 and the rest of its byte in the row above it. POV-Ray 3.7.0.10 takes index 1 everywhere; the format's definition holds here.
TEST_F(ColorMappedFile, BmpPacksSingleBits) {
  const auto image = read_color_mapped_bmp(write(bmp(1, 9, 2, 0, {0xa0, 0x80, 0, 0, 0x7f, 0x00, 0, 0})), error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1));
}

TEST_F(ColorMappedFile, BmpRunsRepeatAndJump) {  // 2 x index 1, end of row; literal 0 1 2 and its padding; end
  const auto image = read_color_mapped_bmp(write(bmp(8, 3, 2, 1, {2, 1, 0, 0, 0, 3, 0, 1, 2, 0, 0, 1})), error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(0, 1, 2, 1, 1, 0));
}

TEST_F(ColorMappedFile, BmpRowsMayBeFilledUp) {  // 3 x index 1 and a fourth pixel beyond the row, as ImageMagick writes; row of 2
  const auto image = read_color_mapped_bmp(write(bmp(8, 3, 2, 1, {3, 1, 1, 0, 0, 0, 4, 2, 0, 1})), error_);
  ASSERT_TRUE(image) << error_;
  EXPECT_THAT(image->indices, ElementsAre(2, 2, 2, 1, 1, 1));
}

TEST_F(ColorMappedFile, BmpRunThatLeavesThePictureIsAnError) {
  EXPECT_FALSE(read_color_mapped_bmp(write(bmp(8, 3, 1, 1, {3, 1, 0, 0, 1, 1, 0, 1})), error_));
  EXPECT_THAT(error_, HasSubstr("leaves the picture"));
}

TEST_F(ColorMappedFile, ShortFileIsAnError) {
  EXPECT_FALSE(read_color_mapped_bmp(write(bmp(8, 3, 2, 0, {0, 1})), error_));
  EXPECT_THAT(error_, HasSubstr("ends too early"));
}

TEST_F(ColorMappedFile, IndexBeyondThePaletteIsAnError) {
  EXPECT_FALSE(read_color_mapped_bmp(write(bmp(8, 1, 1, 0, {3, 0, 0, 0})), error_));
  EXPECT_THAT(error_, HasSubstr("outside the palette"));
}

TEST_F(ColorMappedFile, TrueColorIsLeftToOthers) {
  EXPECT_FALSE(read_color_mapped_bmp(write(bmp(24, 1, 1, 0, {0, 0, 0, 0})), error_));
  EXPECT_EQ(error_, "");
}

}  // namespace
}  // namespace lute
