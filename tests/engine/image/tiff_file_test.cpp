// TIFF files by way of ImageFiles. The pictures of the reference are POV-Ray 3.7.0.10's, 16 bits a channel.
#include "engine/image/image_file.hpp"
#include "tests/temporary_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace lute {
namespace {

constexpr unsigned kGrey = 1, kRgb = 2, kPalette = 3;           // PhotometricInterpretation
constexpr unsigned kUnknown = 0, kAssociated = 1, kBeside = 2;  // ExtraSamples

// A file of one row, not compressed.
struct TiffRow {
  unsigned width = 1, bits = 8, samples = 1, photometric = kGrey;
  std::string pixels;
  std::vector<unsigned> extra, colors;  // ExtraSamples and ColorMap, if not empty
  bool big_endian = false;

  std::string bytes() const {
    std::map<unsigned, std::vector<unsigned>> tags = {{256, {width}}, {257, {1}}, {258, std::vector<unsigned>(samples, bits)}, {259, {1}},
                                                      {262, {photometric}}, {273, {8}}, {277, {samples}}, {278, {1}},
                                                      {279, {static_cast<unsigned>(pixels.size())}}, {284, {1}}};
    if (!extra.empty()) tags[338] = extra;
    if (!colors.empty()) tags[320] = colors;
    const std::string body = pixels + std::string(pixels.size() % 2, '\0');
    std::string directory = number(static_cast<unsigned>(tags.size()), 2), beyond;
    const std::size_t end = 8 + body.size() + 2 + 12 * tags.size() + 4;
    for (const auto& [tag, values] : tags) {
      std::string content;
      for (const unsigned v : values) content += number(v, 2);
      directory += number(tag, 2) + number(3, 2) + number(static_cast<unsigned>(values.size()), 4);
      if (content.size() > 4) {
        directory += number(static_cast<unsigned>(end + beyond.size()), 4);
        beyond += content;
      } else {
        directory += content + std::string(4 - content.size(), '\0');
      }
    }
    return (big_endian ? "MM" : "II") + number(42, 2) + number(static_cast<unsigned>(8 + body.size()), 4) + body + directory + number(0, 4) + beyond;
  }
  std::string number(unsigned value, int size) const {
    std::string text;
    for (int i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * (big_endian ? size - 1 - i : i) & 255);
    return text;
  }
};

class TiffFile : public testing::Test {
 protected:
  ~TiffFile() override { std::filesystem::remove(path_); }

  ImagePtr load(const TiffRow& row) {
    std::ofstream(path_, std::ios::binary) << row.bytes();
    ImageFiles files;
    ImagePtr image = files.load(path_, {}, error_);
    EXPECT_NE(image, nullptr) << error_;
    return image;
  }

  const std::string path_ = temporary_path("tiff_file") + ".tif";
  std::string error_;
};

// An image_map of red 103, alpha 153 gives 0.405228734 = (103 · 153 + 127) div 255 / 153; image_pattern sees 62 / 255.
TEST_F(TiffFile, ColorsAreMultipliedByAlpha) {
  const ImagePtr image = load({1, 8, 4, kRgb, std::string("\x67\0\xB7\x99", 4), {kBeside}, {}});
  ASSERT_NE(image, nullptr);
  EXPECT_TRUE(image->premultiplied());
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.r, 62 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.b, 110 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(0, 0).alpha, 153 / 255.0f);
}

// Grey 7, 69 with the alpha 38, 100 beside it: image_pattern sees 7 · 257 and 69 · 257 of 65535, use_alpha 1 minus alpha.
TEST_F(TiffFile, GreyIsNotMultipliedByAlpha) {
  const ImagePtr image = load({2, 8, 2, kGrey, "\7\x26\x45\x64", {kBeside}, {}});
  ASSERT_NE(image, nullptr);
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.g, 7 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(1, 0).rgb.g, 69 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(1, 0).alpha, 100 / 255.0f);
  EXPECT_TRUE(image->premultiplied());
}

// image_map shows the second channel of neither: 8 bits of which nothing is said, 16 bits of any kind. use_alpha sees 0.
TEST_F(TiffFile, GreyHasAlphaOnlyInEightBitsAndByItsName) {
  for (const unsigned extra : {kUnknown, kAssociated, kBeside}) {
    for (const unsigned bits : {8u, 16u}) {
      const ImagePtr image = load({1, bits, 2, kGrey, bits == 8 ? "\x26\x12" : "\x99\x26\x34\x12", {extra}, {}});
      ASSERT_NE(image, nullptr);
      EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.r, 38 / 255.0f) << bits << ' ' << extra;
      EXPECT_EQ(image->pixel(0, 0).alpha == 1, bits == 16 || extra == kUnknown) << bits << ' ' << extra;
      EXPECT_TRUE(image->keeps_alpha());
    }
  }
}

// image_map shows the 16 bits of the colour map, material_map takes the index, use_alpha sees red.
TEST_F(TiffFile, PalettesKeepIndicesAndSixteenBits) {
  std::vector<unsigned> colors(768);
  for (unsigned i = 0; i < 768; ++i) colors[i] = (i % 256 * 977 + i / 256 * 131) % 65536;
  for (const bool big_endian : {false, true}) {
    const ImagePtr image = load({2, 8, 1, kPalette, "\7\x1c", {}, colors, big_endian});
    ASSERT_NE(image, nullptr);
    ASSERT_TRUE(image->is_palette());
    EXPECT_EQ(image->palette().size(), 256u);
    EXPECT_EQ(image->index(0, 0), 7);
    EXPECT_EQ(image->index(1, 0), 28);
    EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.r, 6839 / 65535.0f);
    EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.b, 7101 / 65535.0f);
    EXPECT_FALSE(image->keeps_alpha());
  }
}

// Colours of 49, 80, 111 are shown as 257 times as much where no entry of the map is above 255.
TEST_F(TiffFile, PalettesOfEightBitsAreSeenByTheirValues) {
  std::vector<unsigned> colors(768);
  for (unsigned i = 0; i < 768; ++i) colors[i] = (i % 256 * 7 + i / 256 * 31) % 256;
  const ImagePtr image = load({1, 8, 1, kPalette, "\7", {}, colors});
  ASSERT_NE(image, nullptr);
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.r, 49 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.b, 111 / 255.0f);
}

// POV-Ray ends in an assertion; here the pixels are those of the format's definition.
TEST_F(TiffFile, PixelsOfLessThanAByteAreRead) {
  std::vector<unsigned> colors(48);
  for (unsigned i = 0; i < 48; ++i) colors[i] = i * 1000;
  const ImagePtr palette = load({3, 4, 1, kPalette, "\x2f\x70", {}, colors});
  ASSERT_NE(palette, nullptr);
  EXPECT_EQ(palette->index(0, 0), 2);
  EXPECT_EQ(palette->index(1, 0), 15);
  EXPECT_EQ(palette->index(2, 0), 7);
  const ImagePtr bits = load({3, 1, 1, kGrey, "\xa0", {}, {}});
  ASSERT_NE(bits, nullptr);
  EXPECT_EQ(bits->pixel(0, 0).rgb.r, 1);
  EXPECT_EQ(bits->pixel(1, 0).rgb.r, 0);
}

TEST_F(TiffFile, FileCutAtAnyByteIsRefusedOrWhole) {
  std::vector<unsigned> colors(48);
  for (unsigned i = 0; i < 48; ++i) colors[i] = i * 1000;
  const std::string whole = TiffRow{3, 4, 1, kPalette, "\x2f\x70", {}, colors}.bytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::ofstream(path_, std::ios::binary) << whole.substr(0, length);
    ImageFiles files;
    error_.clear();
    EXPECT_EQ(files.load(path_, {}, error_), nullptr) << length;
    EXPECT_FALSE(error_.empty()) << length;
  }
}

}  // namespace
}  // namespace lute
