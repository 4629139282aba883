#include "engine/output/write_image.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/image/format_library.hpp"
#include "engine/output/atomic_file.hpp"
#include "tests/file_text.hpp"
#include "tests/temporary_path.hpp"

namespace lute {
namespace {

namespace fs = std::filesystem;

class WriteImage : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = temporary_path("write_image");
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

Film gradient() {
  Film film(5, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) film.at(x, y) = {{static_cast<float>(x) / 4, static_cast<float>(y) / 3, 0.2f}, 0, 0};
  }
  return film;
}

const WorkingSpace kLinear{GammaMode::kPower, 1};

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

TEST_F(WriteImage, PngDeclaresSrgb) {  // chapter 30 §12 F: gAMA 45455 and an sRGB chunk
  write_image(path("a.png"), gradient(), kLinear, {});
  const std::string bytes = test::file_text(path("a.png"));
  ASSERT_NE(bytes.find("gAMA"), std::string::npos);
  EXPECT_EQ(big_endian(bytes, bytes.find("gAMA") + 4), 45455u);
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
}

TEST_F(WriteImage, PngDeclaresAPowerCurve) {
  write_image(path("a.png"), gradient(), kLinear, {.file_gamma = GammaCurve::power(1.8)});
  const std::string bytes = test::file_text(path("a.png"));
  EXPECT_EQ(big_endian(bytes, bytes.find("gAMA") + 4), 55556u);
  EXPECT_EQ(bytes.find("sRGB"), std::string::npos);
}

TEST_F(WriteImage, EveryFormatCanBeReadBack) {
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;
  for (const FileFormat format :
       {FileFormat::kPng, FileFormat::kTarga, FileFormat::kTargaRle, FileFormat::kBmp, FileFormat::kPpm,
        FileFormat::kJpeg, FileFormat::kOpenExr, FileFormat::kRadianceHdr}) {
    const std::string file = path(("a" + std::string(traits_of(format).extension)).c_str());
    const OutputSettings settings{.format = format, .file_gamma = GammaCurve::linear()};
    write_image(file, gradient(), kLinear, settings);
    ImagePixels pixels;
    ImageFileInfo info;
    ASSERT_TRUE(library->read(file, pixels, info, error)) << file << ": " << error;
    ASSERT_EQ(pixels.width, 5);
    ASSERT_EQ(pixels.height, 4);
    ASSERT_EQ(pixels.channels, 3);
    const float tolerance = format == FileFormat::kJpeg ? 0.06f : 1.0f / 127;
    const std::size_t last_row_second = (3 * 5 + 1) * 3;
    EXPECT_NEAR(pixels.values[last_row_second], 0.25f, tolerance) << file;
    EXPECT_NEAR(pixels.values[last_row_second + 1], 1.0f, tolerance) << file;
    EXPECT_NEAR(pixels.values[last_row_second + 2], 0.2f, tolerance) << file;
  }
}

TEST_F(WriteImage, AlphaIsKeptByTheFormatsThatHaveIt) {
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;
  Film film(2, 1);
  film.at(0, 0) = {{0.25f, 0, 0}, 0, 0.5f};
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kTarga, FileFormat::kBmp, FileFormat::kOpenExr}) {
    const std::string file = path(("a" + std::string(traits_of(format).extension)).c_str());
    write_image(file, film, kLinear, {.format = format, .alpha = true, .file_gamma = GammaCurve::linear()});
    ImagePixels pixels;
    ImageFileInfo info;
    ASSERT_TRUE(library->read(file, pixels, info, error)) << file << ": " << error;
    ASSERT_EQ(pixels.channels, 4) << file;
    EXPECT_NEAR(pixels.values[0], format == FileFormat::kOpenExr ? 0.25f : 0.5f, 0.003f) << file;
    EXPECT_NEAR(pixels.values[3], 0.5f, 0.003f) << file;
  }
}

TEST_F(WriteImage, FewBitsFillABytesUpperBitsFirst) {  // chapter 30 §7.8: v<<3 | v>>2
  std::string error;
  const FormatLibrary* library = format_library(error);
  ASSERT_NE(library, nullptr) << error;
  Film film(1, 1);
  film.at(0, 0).rgb = Rgb(0.002f);
  write_image(path("a.png"), film, kLinear, {.bits = 5});
  ImagePixels pixels;
  ImageFileInfo info;
  ASSERT_TRUE(library->read(path("a.png"), pixels, info, error)) << error;
  EXPECT_NEAR(pixels.values[0], 8.0f / 255, 1e-6);
}

TEST_F(WriteImage, LeavesNothingButThePicture) {
  write_image(path("a.png"), gradient(), kLinear, {});
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteImage, FailureKeepsTheOldFile) {
  std::ofstream(path("a.exr")) << "old";
  fs::create_directories(folder_ / "directory.png");
  EXPECT_THROW(write_image(path("directory.png"), gradient(), kLinear, {}), std::runtime_error);
  EXPECT_THROW(write_image(path("missing/a.png"), gradient(), kLinear, {}), std::runtime_error);
  EXPECT_EQ(test::file_text(path("a.exr")), "old");
  EXPECT_EQ(files(), 2u);
}

TEST_F(WriteImage, AbandonedFileDisappears) {
  std::ofstream(path("a.png")) << "old";
  {
    const AtomicFile file(path("a.png"));
    std::ofstream(file.temporary_path()) << "half";
    EXPECT_EQ(files(), 2u);
    EXPECT_EQ(test::file_text(path("a.png")), "old");
  }
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(test::file_text(path("a.png")), "old");
}

TEST_F(WriteImage, WritesThroughALink) {
  std::ofstream(path("target.png")) << "old";
  fs::create_symlink("target.png", folder_ / "link.png");
  write_image(path("link.png"), gradient(), kLinear, {});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  EXPECT_EQ(test::file_text(path("target.png")).substr(1, 3), "PNG");
}

TEST_F(WriteImage, ADeviceIsNotReplaced) {
  write_image("/dev/null", gradient(), kLinear, {});
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

}  // namespace
}  // namespace lute
