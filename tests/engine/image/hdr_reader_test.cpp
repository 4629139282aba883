#include "engine/image/hdr_reader.hpp"
#include "tests/engine/image/linear_colors.hpp"
#include "tests/temporary_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lute {
namespace {

using ::testing::ElementsAre;
using namespace std::string_literals;

class Hdr : public testing::Test {
 protected:
  ~Hdr() override { std::filesystem::remove(path_); }

  void write(const std::string& size, const std::string& pixels, const std::string& lines = "FORMAT=32-bit_rle_rgbe\n") {
    std::ofstream(path_, std::ios::binary) << "#?RADIANCE\n" << lines << "\n" << size << "\n" << pixels;
  }
  // What stands for a byte with the exponent 136: the byte and a half.
  std::vector<float> read() {
    HdrContent content;
    EXPECT_TRUE(read_hdr(path_, content, error_)) << error_;
    return content.values;
  }
  std::string error() {
    HdrContent content;
    EXPECT_FALSE(read_hdr(path_, content, error_));
    return error_;
  }

  const std::string path_ = temporary_path("hdr") + ".hdr";
  std::string error_;
};

// POV-Ray 3.7.0.10 reads such a file, too.
TEST_F(Hdr, LinesMayEndInReturnAndNewline) {
  std::ofstream(path_, std::ios::binary) << "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" << "\x10\x20\x30\x88"s;
  EXPECT_THAT(read(), ElementsAre(16.5f, 32.5f, 48.5f));
}

// Measured with POV-Ray 3.7.0.10: the bytes 103, 0, 183 with the exponent 128 are 0.404296875, 0.001953125, 0.716796875: half a step
// above the byte over 256. So it is, too, where the largest byte is below 128, even 0; but the exponent 0 is black.
TEST_F(Hdr, ColorsAreInTheMiddleOfTheirStep) {
  write("-Y 1 +X 4", "\x67\0\xB7\x80"s + "\0\0\0\x80"s + "\3\2\1\x82"s + "\1\2\3\0"s);
  EXPECT_THAT(read(), ElementsAre(0.404296875f, 0.001953125f, 0.716796875f,             //
                                  0.001953125f, 0.001953125f, 0.001953125f,             //
                                  3.5f / 64, 2.5f / 64, 1.5f / 64, 0, 0, 0));
}

// Measured with POV-Ray 3.7.0.10: +Y for -Y and -X for +X change nothing; EXPOSURE, GAMMA, XYZE and a missing FORMAT neither.
TEST_F(Hdr, OrientationAndVariablesChangeNothing) {
  const std::string pixels = "\1\1\1\x88\2\2\2\x88"s;
  for (const char* size : {"-Y 2 +X 1", "+Y 2 +X 1", "-Y 2 -X 1"}) {
    write(size, pixels);
    EXPECT_THAT(read(), ElementsAre(1.5f, 1.5f, 1.5f, 2.5f, 2.5f, 2.5f)) << size;
  }
  for (const char* lines : {"", "FORMAT=32-bit_rle_xyze\n", "# a comment\nEXPOSURE=2\nGAMMA=2.2\nFORMAT=32-bit_rle_rgbe\n"}) {
    write("-Y 2 +X 1", pixels, lines);
    EXPECT_THAT(read(), ElementsAre(1.5f, 1.5f, 1.5f, 2.5f, 2.5f, 2.5f)) << lines;
  }
}

// As POV-Ray 3.7.0.10 shows it: three more of the pixel before; 1, 1, 1 at the beginning of a row is a colour.
TEST_F(Hdr, OldRunsRepeatThePixelBefore) {
  write("-Y 2 +X 4", "\7\7\7\x88\1\1\1\3"s + "\1\1\1\x88\2\2\2\x88\1\1\1\2"s);
  const std::vector<float> values = read();
  ASSERT_EQ(values.size(), 24u);
  const float expected[8] = {7.5f, 7.5f, 7.5f, 7.5f, 1.5f, 2.5f, 2.5f, 2.5f};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(values[3 * i], expected[i]) << i;
}

TEST_F(Hdr, NewRunsAreOfEachByte) {
  write("-Y 1 +X 8", "\2\2\0\x08"s + "\x88\7"s + "\x08\1\2\3\4\5\6\7\x08"s + "\x85\1\3\2\3\4"s + "\x88\x88"s);
  const std::vector<float> values = read();
  ASSERT_EQ(values.size(), 24u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(values[3 * i], 7.5f);
    EXPECT_EQ(values[3 * i + 1], static_cast<float>(i) + 1.5f);
    EXPECT_EQ(values[3 * i + 2], i < 5 ? 1.5f : static_cast<float>(i) - 2.5f);
  }
}

TEST_F(Hdr, BrokenFilesAreErrors) {
  write("-Y 1 +X 2", "\1\1\1\x88"s);
  EXPECT_EQ(error(), "it ends too early");
  for (const char* size : {"", "-Y 0 +X 1", "-Y 1 +X", "-Y 1 +X 99999999999", "-Y -1 +X 1"}) {
    write(size, "\1\1\1\x88"s);
    EXPECT_EQ(error(), "its size is not possible") << size;
  }
  write("-Y 1 +X 2", "\7\7\7\x88\1\1\1\2"s);
  EXPECT_EQ(error(), "a run leaves its row");
  write("-Y 1 +X 8", "\2\2\0\x08\x89\1"s);
  EXPECT_EQ(error(), "a run leaves its row");
  write("-Y 1 +X 8", "\2\2\0\x08\0\0"s);
  EXPECT_EQ(error(), "a run leaves its row");
  write("-Y 1 +X 8", "\2\2\0\x09\x89\1"s);
  EXPECT_EQ(error(), "a row has another length");
  std::ofstream(path_, std::ios::binary) << "P6\n\n-Y 1 +X 1\nabcd";
  EXPECT_EQ(error(), "it is not in HDR format");
}

TEST_F(Hdr, ImageIsLinearLightAndKeepsAlpha) {
  write("-Y 1 +X 1", "\x67\0\xB7\x80"s);
  ImageFiles files;
  const ImagePtr image = files.load(path_, colors_in_linear_space(), error_);
  ASSERT_NE(image, nullptr) << error_;
  EXPECT_EQ(image->pixel(0, 0).rgb, Rgb(0.404296875f, 0.001953125f, 0.716796875f));
  EXPECT_FALSE(image->has_alpha());
  EXPECT_TRUE(image->keeps_alpha());
}

}  // namespace
}  // namespace lute
