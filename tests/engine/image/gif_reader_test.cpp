#include "engine/image/gif_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lute {
namespace {

// Red, green, blue, white / red, red, green, blue / blue, blue, white, red, as ImageMagick writes it with a palette of four colours.
const std::vector<std::uint8_t> kPlain = {
    0x47, 0x49, 0x46, 0x38, 0x39, 0x61, 0x04, 0x00, 0x03, 0x00, 0xf1, 0x03, 0x00, 0xff, 0x00, 0x00, 0x00, 0xff,
    0x00, 0x00, 0x00, 0xff, 0xff, 0xff, 0xff, 0x21, 0xf9, 0x04, 0x00, 0x00, 0x00, 0x00, 0x00, 0x2c, 0x00, 0x00,
    0x00, 0x00, 0x04, 0x00, 0x03, 0x00, 0x00, 0x02, 0x05, 0x44, 0x34, 0x60, 0xc2, 0x59, 0x00, 0x3b};
// Red, green / blue, white / red, red / green, blue / blue, white, interlaced, with blue transparent (index 3).
const std::vector<std::uint8_t> kInterlaced = {
    0x47, 0x49, 0x46, 0x38, 0x39, 0x61, 0x02, 0x00, 0x05, 0x00, 0xf1, 0x02, 0x00, 0xff, 0x00, 0x00, 0x00, 0xff,
    0x00, 0xff, 0xff, 0xff, 0x00, 0x00, 0x00, 0x21, 0xf9, 0x04, 0x01, 0x00, 0x00, 0x03, 0x00, 0x2c, 0x00, 0x00,
    0x00, 0x00, 0x02, 0x00, 0x05, 0x00, 0x40, 0x02, 0x05, 0x44, 0x26, 0x00, 0x78, 0x05, 0x00, 0x3b};

class Gif : public testing::Test {
 protected:
  bool read(const std::vector<std::uint8_t>& bytes) {
    const std::string path = (std::filesystem::temp_directory_path() / "lute_gif_reader_test.gif").string();
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    content = {};
    return read_gif(path, content, error);
  }
  GifContent content;
  std::string error;
};

TEST_F(Gif, KeepsIndicesAndPalette) {
  ASSERT_TRUE(read(kPlain)) << error;
  EXPECT_EQ(content.width, 4);
  EXPECT_EQ(content.height, 3);
  EXPECT_EQ(content.indices, (std::vector<std::uint8_t>{0, 1, 2, 3, 0, 0, 1, 2, 2, 2, 3, 0}));
  ASSERT_EQ(content.palette.size(), 4u);
  EXPECT_EQ(content.palette[1].rgb.g, 1);
  EXPECT_EQ(content.palette[1].rgb.r, 0);
  EXPECT_EQ(content.palette[2].alpha, 1);
}

TEST_F(Gif, PutsInterlacedRowsInPlaceAndKnowsTheTransparentIndex) {
  ASSERT_TRUE(read(kInterlaced)) << error;
  EXPECT_EQ(content.indices, (std::vector<std::uint8_t>{0, 1, 3, 2, 0, 0, 1, 3, 3, 2}));
  EXPECT_EQ(content.palette[3].alpha, 0);
  EXPECT_EQ(content.palette[2].alpha, 1);
}

TEST_F(Gif, FilesCutAtAnyByteAreReadInPartOrRefused) {
  for (std::size_t length = 0; length < kPlain.size(); ++length) {
    const bool good = read({kPlain.begin(), kPlain.begin() + static_cast<std::ptrdiff_t>(length)});
    if (good) EXPECT_EQ(content.indices.size(), 12u) << length;
    else EXPECT_FALSE(error.empty()) << length;
  }
  // The picture begins at byte 33; its packed data at byte 44.
  EXPECT_FALSE(read({kPlain.begin(), kPlain.begin() + 40}));
}

TEST_F(Gif, AnyByteMayBeWrong) {
  for (std::size_t at = 0; at < kPlain.size(); ++at)
    for (const int value : {0, 1, 0x2c, 0x7f, 0xff}) {
      std::vector<std::uint8_t> bytes = kPlain;
      bytes[at] = static_cast<std::uint8_t>(value);
      if (!read(bytes)) continue;
      const auto highest = *std::max_element(content.indices.begin(), content.indices.end());
      EXPECT_LT(highest, content.palette.size()) << at << ' ' << value;
    }
}

}  // namespace
}  // namespace lute
