// JPEG files read without the library of formats must give the pixels that it gives.
#include "engine/image/jpeg_reader.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "engine/image/format_library.hpp"
#include "tests/temporary_path.hpp"

namespace lute {
namespace {

class JpegReader : public testing::TestWithParam<int> {};

TEST_P(JpegReader, GivesThePixelsOfTheFormatLibrary) {
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;
  const int channels = GetParam();
  ImagePixels pixels{20, 13, channels, {}};
  for (int i = 0; i < 20 * 13 * channels; ++i) pixels.values.push_back(0.5f + 0.5f * std::sin(0.05f * static_cast<float>(i)));
  const std::string path = temporary_path("jpeg_reader.jpg");
  ASSERT_TRUE(library->write(path, pixels, {.format = "jpeg", .type = ChannelType::kUint8}, error)) << error;
  ImagePixels expected;
  ImageFileInfo info;
  ASSERT_TRUE(library->read(path, expected, info, error)) << error;

  JpegContent jpeg;
  ASSERT_TRUE(read_jpeg(path, jpeg, error)) << error;
  EXPECT_EQ(jpeg.width, 20);
  EXPECT_EQ(jpeg.height, 13);
  ASSERT_EQ(jpeg.channels, channels);
  ASSERT_EQ(jpeg.bytes.size(), expected.values.size());
  for (std::size_t i = 0; i < jpeg.bytes.size(); ++i) EXPECT_EQ(jpeg.bytes[i], std::lround(255 * expected.values[i])) << i;
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Channels, JpegReader, testing::Values(1, 3));

TEST(JpegReader, SaysWhyAFileCannotBeRead) {
  JpegContent jpeg;
  std::string error;
  EXPECT_FALSE(read_jpeg("/nonexistent/picture.jpg", jpeg, error));
  EXPECT_NE(error.find("Cannot open"), std::string::npos);
  const std::string path = temporary_path("no_picture.jpg");
  std::ofstream(path) << "this is text";
  EXPECT_FALSE(read_jpeg(path, jpeg, error));
  EXPECT_NE(error.find("Cannot read JPEG image"), std::string::npos);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace lute
