#include "engine/image/tga_reader.hpp"
#include "tests/engine/image/linear_colors.hpp"
#include "tests/temporary_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lute {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using Bytes = std::vector<std::uint8_t>;

struct Colors {
  int bits = 0;
  Bytes bytes;
};

class Tga : public testing::Test {
 protected:
  ~Tga() override { std::filesystem::remove(path_); }

  // Two rows of three pixels, or one of `width`.
  void write(int type, int bits, const Bytes& pixels, int order = 0x20, const Colors& colors = {}, int width = 3, int height = 2) {
    const auto small = [](std::size_t v) { return static_cast<std::uint8_t>(v); };
    const std::size_t count = colors.bits == 0 ? 0 : colors.bytes.size() / static_cast<std::size_t>((colors.bits + 7) / 8);
    Bytes file = {0, small(count > 0), static_cast<std::uint8_t>(type), 0, 0, small(count), 0, static_cast<std::uint8_t>(colors.bits)};
    file.insert(file.end(), {0, 0, 0, 0, static_cast<std::uint8_t>(width), 0, static_cast<std::uint8_t>(height), 0,
                             static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(order)});
    file.insert(file.end(), colors.bytes.begin(), colors.bytes.end());
    file.insert(file.end(), pixels.begin(), pixels.end());
    std::ofstream(path_, std::ios::binary).write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  }
  TgaContent read() {
    TgaContent content;
    EXPECT_TRUE(read_tga(path_, content, error_)) << error_;
    return content;
  }

  const std::string path_ = temporary_path("tga") + ".tga";
  std::string error_;
};

// Measured with POV-Ray 3.7.0.10, image_pattern of 16-bit pixels: 31, 0, 0 has the grey value 0.297 · 248/255; without the highest bit a pixel
// of an image_map cannot be seen, whether or not the header counts an attribute bit.
TEST_F(Tga, SixteenBitsAreFiveForEachColorAndOpacity) {
  for (const int order : {0x20, 0x21}) {
    write(2, 16, {0x00, 0x7c, 0xe0, 0x83, 0x43, 0x04}, order, {}, 3, 1);
    const TgaContent content = read();
    EXPECT_EQ(content.channels, 4);
    EXPECT_THAT(content.bytes, ElementsAre(248, 0, 0, 0, 0, 248, 0, 255, 8, 16, 24, 0));
  }
}

TEST_F(Tga, FifteenBitsAreOpaque) {
  write(2, 15, {0x00, 0x7c, 0xe0, 0x83, 0x43, 0x04}, 0x20, {}, 3, 1);
  const TgaContent content = read();
  EXPECT_EQ(content.channels, 3);
  EXPECT_THAT(content.bytes, ElementsAre(248, 0, 0, 0, 248, 0, 8, 16, 24));
}

// Measured with POV-Ray 3.7.0.10: `use_alpha` of a map of 32 bits sees 1 minus its fourth byte, with no attribute bits in the header.
TEST_F(Tga, PalettesHaveAlpha) {
  write(1, 8, {0, 1, 0}, 0x20, {32, {1, 2, 3, 51, 4, 5, 6, 255}}, 3, 1);
  const TgaContent content = read();
  ASSERT_EQ(content.palette.size(), 2u);
  EXPECT_FLOAT_EQ(content.palette[0].rgb.r, 3 / 255.0f);
  EXPECT_FLOAT_EQ(content.palette[0].alpha, 51 / 255.0f);
  EXPECT_EQ(content.palette[1].alpha, 1);
}

TEST_F(Tga, PalettesOfSixteenBitsHaveOpacityAndOfFifteenNot) {
  const Bytes colors = {0x00, 0x7c, 0xe0, 0x83};
  write(1, 8, {0, 1, 0}, 0x20, {16, colors}, 3, 1);
  TgaContent content = read();
  EXPECT_FLOAT_EQ(content.palette[0].rgb.r, 248 / 255.0f);
  EXPECT_EQ(content.palette[0].alpha, 0);
  EXPECT_EQ(content.palette[1].alpha, 1);
  write(1, 8, {0, 1, 0}, 0x20, {15, colors}, 3, 1);
  EXPECT_EQ(read().palette[0].alpha, 1);
}

// Version 1 of the format lets packets go on into the next row. POV-Ray 3.7.0.10 drops their rest and leaves the last rows black.
TEST_F(Tga, PacketsGoOnInTheNextRow) {
  write(9, 8, {0x80 | 3, 1, 1, 0, 1}, 0x20, {24, {0, 0, 0, 0, 0, 255}});
  EXPECT_THAT(read().bytes, ElementsAre(1, 1, 1, 1, 0, 1));
  write(10, 24, {0x80 | 3, 1, 2, 3, 1, 4, 5, 6, 7, 8, 9});
  EXPECT_THAT(read().bytes, ElementsAreArray({3, 2, 1, 3, 2, 1, 3, 2, 1, 3, 2, 1, 6, 5, 4, 9, 8, 7}));
  write(10, 16, {0x80 | 3, 0x00, 0x7c, 1, 0xe0, 0x83, 0x1f, 0x80});
  EXPECT_EQ(read().bytes[12], 248);  // the fourth pixel's red
  write(11, 8, {0x80 | 5, 7});
  EXPECT_THAT(read().bytes, ElementsAre(7, 7, 7, 7, 7, 7));
}

TEST_F(Tga, LastPacketMayBeTooLong) {
  write(11, 8, {0x80 | 127, 7});
  EXPECT_EQ(read().bytes, Bytes(6, 7));
}

// Measured with POV-Ray 3.7.0.10: bit 5 of the descriptor counts, bit 4, from right to left, does not.
TEST_F(Tga, RowsRunUpwardUnlessTheHeaderSaysOtherwise) {
  const Bytes pixels = {1, 2, 3, 4, 5, 6};
  write(3, 8, pixels, 0);
  EXPECT_THAT(read().bytes, ElementsAre(4, 5, 6, 1, 2, 3));
  write(3, 8, pixels, 0x30);
  EXPECT_EQ(read().bytes, pixels);
}

TEST_F(Tga, GreyOfSixteenBitsHasAlpha) {
  write(3, 16, {1, 2, 3, 4, 5, 6}, 0x20, {}, 3, 1);
  const TgaContent content = read();
  EXPECT_EQ(content.channels, 2);
  EXPECT_THAT(content.bytes, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(Tga, TrueColorMayBringAPalette) {
  write(2, 24, {1, 2, 3}, 0x20, {24, {9, 9, 9}}, 1, 1);
  const TgaContent content = read();
  EXPECT_TRUE(content.palette.empty());
  EXPECT_THAT(content.bytes, ElementsAre(3, 2, 1));
}

TEST_F(Tga, IndicesOfTwoBytesAreLeftToOthers) {
  write(1, 16, {0, 0, 1, 0, 0, 0}, 0x20, {24, {0, 0, 0, 0, 0, 255}}, 3, 1);
  TgaContent content;
  EXPECT_FALSE(read_tga(path_, content, error_));
  EXPECT_EQ(error_, "");
}

TEST_F(Tga, BrokenFilesAreErrors) {
  const auto error = [&] {
    TgaContent content;
    EXPECT_FALSE(read_tga(path_, content, error_));
    return std::exchange(error_, "");
  };
  write(2, 24, {1, 2, 3});
  EXPECT_EQ(error(), "it ends too early");
  write(0, 24, {});
  EXPECT_EQ(error(), "it is not in TGA format");
  write(2, 24, {}, 0x20, {}, 0, 1);
  EXPECT_EQ(error(), "its size is not possible");
  write(2, 12, {0, 0});
  EXPECT_EQ(error(), "its colours have an unknown size");
  write(3, 24, {0, 0, 0});
  EXPECT_EQ(error(), "its pixels have an unknown size");
  write(1, 8, {0, 1, 2}, 0x20, {24, {0, 0, 0, 0, 0, 255}}, 3, 1);
  EXPECT_EQ(error(), "a pixel's index lies outside the palette");
}

// Measured with POV-Ray 3.7.0.10: 248 of a 16-bit pixel goes through the sRGB curve to 61517 of 65535, alpha is not multiplied in.
TEST_F(Tga, ImageOfSixteenBitsIsDecodedLikeOneOfEight) {
  write(2, 16, {0x00, 0xfc}, 0x20, {}, 1, 1);
  ImageFiles files;
  const ImagePtr image = files.load(path_, colors_in_linear_space(), error_);
  ASSERT_NE(image, nullptr) << error_;
  EXPECT_NEAR(65535 * image->pixel(0, 0).rgb.r, 61517, 1);
  EXPECT_EQ(image->pixel(0, 0).alpha, 1);
  EXPECT_FALSE(image->premultiplied());
}

}  // namespace
}  // namespace lute
