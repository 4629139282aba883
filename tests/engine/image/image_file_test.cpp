#include "engine/image/image_file.hpp"
#include "tests/engine/image/linear_colors.hpp"
#include "tests/temporary_path.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace lute {
namespace {

class ImageFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Pixels as bytes; palette images: `colors` has RGBA entries.
  std::string write_png(const std::string& name, std::uint32_t format, unsigned width, unsigned height,
                        const std::vector<std::uint8_t>& pixels, const std::vector<std::uint8_t>& colors = {}) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    image.colormap_entries = static_cast<png_uint_32>(colors.size() / 4);
    const std::string file = path(name);
    EXPECT_NE(png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, colors.empty() ? nullptr : colors.data()), 0);
    return file;
  }
  ImagePtr load(const std::string& file, const ImageFileOptions& options = {}) {
    std::string error;
    ImagePtr image = files_.load(file, options, error);
    EXPECT_NE(image, nullptr) << error;
    return image;
  }

  const std::filesystem::path folder_ = temporary_path("image_file");
  ImageFiles files_;
};

// Chapter 30 §7.9: grey files are brought back to 8 bits by truncation, which loses 1 for some codes.
TEST_F(ImageFile, GreyPngLosesACodeHereAndThere) {
  const std::string file = write_png("grey.png", PNG_FORMAT_GRAY, 7, 1, {10, 30, 60, 100, 128, 200, 255});
  const ImagePtr image = load(file);
  const int expected[7] = {9, 30, 60, 99, 128, 199, 255};
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(std::lround(image->pixel(i, 0).rgb.r * 255), expected[i]);
    EXPECT_EQ(image->height_at(i, 0), 257 * expected[i]);
  }
}

TEST_F(ImageFile, ColorsAreDecodedAndHeightsAreNot) {
  const std::string file = write_png("rgb.png", PNG_FORMAT_RGB, 1, 1, {188, 64, 0});
  EXPECT_NEAR(load(file, colors_in_linear_space())->pixel(0, 0).rgb.r, 0.5029f, 1e-4f);  // sRGB 188
  const ImagePtr raw = load(file);
  EXPECT_FLOAT_EQ(raw->pixel(0, 0).rgb.r, 188 / 255.0f);
  EXPECT_EQ(raw->height_at(0, 0), 188 * 256 + 64);
  EXPECT_FALSE(raw->has_alpha());
}

TEST_F(ImageFile, WrittenGammaOverridesTheFile) {
  const std::string file = write_png("gamma.png", PNG_FORMAT_RGB, 1, 1, {128, 128, 128});
  ImageFileOptions options = colors_in_linear_space();
  options.file_gamma = GammaCurve::power(2);
  EXPECT_NEAR(load(file, options)->pixel(0, 0).rgb.g, (128 / 255.0f) * (128 / 255.0f), 1e-6f);
  options.for_colors = false;
  EXPECT_NEAR(load(file, options)->pixel(0, 0).rgb.g, (128 / 255.0f) * (128 / 255.0f), 1e-6f);
}

TEST_F(ImageFile, PaletteIsKept) {
  const std::string file = write_png("palette.png", PNG_FORMAT_RGBA_COLORMAP, 3, 1, {0, 2, 1}, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 51});
  const ImagePtr image = load(file);
  ASSERT_TRUE(image->is_palette());
  EXPECT_EQ(image->index(1, 0), 2);
  EXPECT_EQ(image->height_at(1, 0), 512);
  EXPECT_EQ(image->pixel(0, 0).rgb, Rgb(1, 0, 0));
  EXPECT_NEAR(image->pixel(1, 0).alpha, 0.2f, 1e-6f);
  EXPECT_TRUE(image->has_alpha());
}

TEST_F(ImageFile, AlphaIsNeverDecoded) {
  const std::string file = write_png("alpha.png", PNG_FORMAT_RGBA, 1, 1, {255, 255, 255, 51});
  EXPECT_NEAR(load(file, colors_in_linear_space())->pixel(0, 0).alpha, 0.2f, 1e-6f);
}

TEST_F(ImageFile, PortableMapsAreTakenAsTheyAre) {
  const std::string file = path("map.ppm");
  std::ofstream(file, std::ios::binary) << "P6\n2 1\n255\n" << std::string("\x80\x00\x00\x00\x80\x00", 6);
  const ImagePtr image = load(file, colors_in_linear_space());
  EXPECT_FLOAT_EQ(image->pixel(0, 0).rgb.r, 128 / 255.0f);
  EXPECT_FLOAT_EQ(image->pixel(1, 0).rgb.g, 128 / 255.0f);
}

// Values of portable maps, measured with POV-Ray 3.7 through a 16-bit picture: with another maximum than 255 the nearest of 65536 codes.
TEST_F(ImageFile, PortableMapsKeepTheirCodes) {
  struct Case {
    const char* name;
    std::string content;
    std::vector<int> codes;  // of the red channel, of 65535
  };
  using namespace std::string_literals;
  const Case cases[] = {
      {"16bit.ppm", "P6\n3 1\n65535\n"s + "\x80\x01\x80\x01\x80\x01"s + "\xff\xff\xff\xff\xff\xff"s + "\0\3\0\3\0\3"s, {32769, 65535, 3}},
      {"16bit.pgm", "P5 3 1 65535\n"s + "\x80\x01\xff\xff\0\3"s, {32769, 65535, 3}},
      {"to1000.ppm", "P6\n2 1\n1000\n"s + "\0\1\0\1\0\1"s + "\3\xe2\3\xe2\3\xe2"s, {66, 65142}},
      {"to100.pgm", "P5\n5 1\n100\n"s + "\1\2\x63\x64\xc8"s, {655, 1311, 64880, 65535, 65535}},
      {"numbers.ppm", "P3\n# a comment\n2 1\n1000\n3 0 0\n9 0 0\n", {197, 590}},
      {"numbers.pgm", "P2 3 1 255 0 1 # the last\n254", {0, 257, 65278}}};
  for (const Case& c : cases) {
    const std::string file = path(c.name);
    std::ofstream(file, std::ios::binary) << c.content;
    const ImagePtr image = load(file, colors_in_linear_space());
    ASSERT_EQ(image->width(), static_cast<int>(c.codes.size())) << c.name;
    for (int i = 0; i < image->width(); ++i)
      EXPECT_EQ(std::lround(65535 * image->pixel(i, 0).rgb.r), c.codes[static_cast<std::size_t>(i)]) << c.name << " " << i;
  }
}

TEST_F(ImageFile, BrokenPortableMapsAreErrors) {
  const char* const contents[] = {"", "P6", "P6\n2 1\n255\nabc", "P6\n0 1\n255\n", "P6\n1 1\n70000\nabc", "P6\n1 1\n0\nabc", "P6\nx 1\n255\nabc",
                                  "P6\n99999999999 1\n255\n", "P3\n1 1\n255\n1 2", "P5\n1 1\n255\na", "P4\n8 1\na"};
  int number = 0;
  for (const char* content : contents) {
    const std::string file = path("broken_" + std::to_string(number++) + ".ppm");
    std::ofstream(file, std::ios::binary) << content;
    std::string error;
    EXPECT_EQ(files_.load(file, {}, error), nullptr) << content;
    EXPECT_FALSE(error.empty()) << content;
  }
}

TEST_F(ImageFile, PalettesOfPngKeepAlpha) {  // use_alpha sees 0 where all of it is opaque, not the red channel
  const ImagePtr palette = load(write_png("p.png", PNG_FORMAT_RGBA_COLORMAP, 2, 1, {0, 1}, {255, 0, 0, 255, 0, 255, 0, 255}));
  EXPECT_TRUE(palette->keeps_alpha());
  EXPECT_FALSE(palette->has_alpha());
  EXPECT_FALSE(load(write_png("c.png", PNG_FORMAT_RGB, 1, 1, {1, 2, 3}))->keeps_alpha());
}

TEST_F(ImageFile, WordAndContentMustAgree) {
  const std::string file = path("map.tga");
  std::ofstream(file, std::ios::binary) << "P6 1 1 255\nabc";
  for (const char* type : {"tga", "tiff", "hdr", "exr"}) {
    ImageFileOptions options;
    options.type = type;
    std::string error;
    EXPECT_EQ(files_.load(file, options, error), nullptr) << type;
    EXPECT_FALSE(error.empty());
  }
  ImageFileOptions options;
  options.type = "ppm";
  EXPECT_NE(load(file, options), nullptr);
  options.type = "pgm";
  std::string error;
  EXPECT_EQ(files_.load(file, options, error), nullptr);
  EXPECT_EQ(error, "it is not in PGM format");
}

TEST_F(ImageFile, BrokenFilesAreErrors) {
  const std::string file = path("broken.png");
  std::ofstream(file, std::ios::binary) << "no png at all";
  std::string error;
  EXPECT_EQ(files_.load(file, {}, error), nullptr);
  EXPECT_FALSE(error.empty());
  error.clear();
  EXPECT_EQ(files_.load(path("missing.png"), {}, error), nullptr);
  EXPECT_FALSE(error.empty());
}

TEST_F(ImageFile, IffIsSaidToBeUnsupported) {
  const std::string file = path("picture.iff");
  std::ofstream(file, std::ios::binary) << "FORM";
  std::string error;
  EXPECT_EQ(files_.load(file, {}, error), nullptr);
  EXPECT_NE(error.find("IFF files are not supported"), std::string::npos) << error;
}

TEST_F(ImageFile, IsLoadedOnceForTheWholeScene) {
  const std::string file = path("once.ppm");
  std::ofstream(file, std::ios::binary) << "P6 1 1 255\nabc";
  std::string error;
  const ImagePtr first = files_.load(file, {}, error);
  ASSERT_NE(first, nullptr) << error;
  std::filesystem::remove(file);
  EXPECT_EQ(files_.load(file, {}, error), first);
}

TEST(GammaCurve, DecodesWhatItEncodes) {
  for (const GammaCurve& curve : {GammaCurve::linear(), GammaCurve::srgb(), GammaCurve::power(2.2)})
    for (const float v : {0.0f, 0.01f, 0.5f, 1.0f}) EXPECT_NEAR(curve.decode(curve.encode(v)), v, 1e-6f);
  EXPECT_EQ(image_type_of("a.b/c.JPG"), "jpeg");
  EXPECT_EQ(image_type_of("a.b/c"), "");
}

}  // namespace
}  // namespace lute
