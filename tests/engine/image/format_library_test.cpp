#include "engine/image/format_library.hpp"
#include "tests/temporary_path.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace lute {
namespace {

class FormatLibraryFiles : public testing::TestWithParam<std::tuple<const char*, const char*, ChannelType, double>> {};

TEST_P(FormatLibraryFiles, KeepWhatWasWritten) {
  const auto& [format, extension, type, tolerance] = GetParam();
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;

  ImagePixels pixels{3, 2, 3, {}};
  for (int i = 0; i < 18; ++i) pixels.values.push_back(static_cast<float>(i) / 17.0f);
  const std::string path = temporary_path(std::string("format_library.") + extension);
  ASSERT_TRUE(library->write(path, pixels, {.format = format, .type = type}, error)) << error;
  ImagePixels read;
  ImageFileInfo info;
  ASSERT_TRUE(library->read(path, read, info, error)) << error;
  ASSERT_EQ(read.width, 3);
  ASSERT_EQ(read.height, 2);
  ASSERT_EQ(read.channels, 3);
  EXPECT_EQ(info.stored, type);
  for (std::size_t i = 0; i < 18; ++i) EXPECT_NEAR(read.values[i], pixels.values[i], tolerance) << i;
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Formats, FormatLibraryFiles,
                         testing::Values(std::tuple("bmp", "bmp", ChannelType::kUint8, 0.5 / 255),
                                         std::tuple("targa", "tga", ChannelType::kUint8, 0.5 / 255),
                                         std::tuple("pnm", "ppm", ChannelType::kUint8, 0.5 / 255),
                                         std::tuple("openexr", "exr", ChannelType::kHalf, 1.0 / 2048)));

TEST(FormatLibrary, SaysWhyAFileCannotBeRead) {
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;
  ImagePixels pixels;
  ImageFileInfo info;
  EXPECT_FALSE(library->read("/nonexistent/picture.png", pixels, info, error));
  EXPECT_FALSE(error.empty());
}

}  // namespace
}  // namespace lute
