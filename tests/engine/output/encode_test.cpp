#include "engine/output/encode.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lute {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

constexpr std::array<float, 9> kGreys{-0.2f, 0, 0.002f, 0.01f, 0.1f, 0.2f, 0.5f, 0.9f, 1.5f};

EncodedImage encoded(const Film& film, const WorkingSpace& working, const OutputSettings& settings) {
  return encode(film, Transfer(working, settings.file_gamma, settings.display_gamma), settings);
}

// Chapter 30 §12 F: the codes of unlit greys.
std::vector<int> grey_codes(const WorkingSpace& working, const OutputSettings& settings) {
  Film film(static_cast<int>(kGreys.size()), 1);
  for (std::size_t i = 0; i < kGreys.size(); ++i) film.at(static_cast<int>(i), 0).rgb = Rgb(kGreys[i]);
  const EncodedImage image = encoded(film, working, settings);
  std::vector<int> codes;
  for (std::size_t i = 0; i < image.codes.size(); i += static_cast<std::size_t>(image.channels))
    codes.push_back(image.codes[i]);
  return codes;
}

const WorkingSpace kLinear{GammaMode::kPower, 1};

TEST(OutputGamma, LinearSceneToSrgbFile) {
  EXPECT_THAT(grey_codes(kLinear, {}), ElementsAre(0, 0, 7, 25, 89, 124, 188, 243, 255));
}

TEST(OutputGamma, SixteenBits) {
  EXPECT_THAT(grey_codes(kLinear, {.bits = 16}), ElementsAre(0, 0, 1693, 6544, 22884, 31754, 48192, 62565, 65535));
}

TEST(OutputGamma, SceneWithoutGammaHandlingIsWrittenAsItIs) {
  EXPECT_THAT(grey_codes({GammaMode::kNone, 1}, {}), ElementsAre(0, 0, 1, 3, 26, 51, 128, 230, 255));
}

TEST(OutputGamma, AssumedGammaAsPower) {
  EXPECT_THAT(grey_codes({GammaMode::kPower, 2.2}, {}), ElementsAre(0, 0, 0, 0, 19, 48, 128, 230, 255));
}

TEST(OutputGamma, AssumedGammaSrgbPassesUnchanged) {
  EXPECT_THAT(grey_codes({GammaMode::kSrgb, 1}, {}), ElementsAre(0, 0, 1, 3, 26, 51, 128, 230, 255));
}

TEST(OutputGamma, FileGammaAsPower) {
  EXPECT_THAT(grey_codes(kLinear, {.file_gamma = GammaCurve::power(2.2)}),
              ElementsAre(0, 0, 15, 31, 90, 123, 186, 243, 255));
  EXPECT_THAT(grey_codes(kLinear, {.file_gamma = GammaCurve::power(1.8)}),
              ElementsAre(0, 0, 8, 20, 71, 104, 174, 241, 255));
  EXPECT_THAT(grey_codes(kLinear, {.file_gamma = GammaCurve::power(1)}),
              ElementsAre(0, 0, 1, 3, 26, 51, 128, 230, 255));
}

TEST(OutputGamma, GreyscalePpmIsNotEncoded) {
  OutputSettings settings{.format = FileFormat::kPpm, .bits = 16, .greyscale = true};
  EXPECT_THAT(grey_codes(kLinear, settings), ElementsAre(0, 0, 131, 655, 6553, 13107, 32768, 58982, 65535));
}

TEST(OutputGamma, FiveBitsAreTheFewest) {
  const EncodedImage image = encoded(Film(1, 1), kLinear, {.bits = 3});
  EXPECT_EQ(image.max, 31);
}

TEST(LinearLight, DecodesScenesWithoutGammaHandling) {  // chapter 30 §12 F: EXR holds 0.2140 for 0.5
  Film film(1, 1);
  film.at(0, 0).rgb = Rgb(0.5f);
  const OutputSettings settings{.format = FileFormat::kOpenExr};
  const ImagePixels image = linear_light(film, Transfer({GammaMode::kNone, 1}, {}, {}), settings);
  EXPECT_NEAR(image.values[0], 0.2140f, 5e-5);
}

// Chapter 30 §12 G: two surfaces seen one behind the other, +UA.
std::vector<std::uint16_t> alpha_codes(const Color& color) {
  Film film(1, 1);
  film.at(0, 0) = color;
  return encoded(film, kLinear, {.alpha = true}).codes;
}

TEST(OutputAlpha, IsStraight) {
  EXPECT_THAT(alpha_codes({{0.75f, 0.375f, 0.1875f}, 0, 0.25f}), ElementsAre(255, 188, 137, 191));
}

TEST(OutputAlpha, FaintColorsKeepTheirHue) {
  EXPECT_THAT(alpha_codes({{0.02f * 0.0199f, 0.04f * 0.0199f, 0.1f * 0.0199f}, 0, 0.9801f}),
              ElementsAre(39, 56, 89, 5));
}

TEST(OutputAlpha, HighlightsRaiseIt) {
  EXPECT_THAT(alpha_codes({{2.25f, 0.375f, 0.1875f}, 0, 0.25f}), ElementsAre(255, 172, 125, 232));
}

TEST(OutputAlpha, ClearIsBlackAndTransparent) { EXPECT_THAT(alpha_codes({{0, 0, 0}, 0, 1}), ElementsAre(0, 0, 0, 0)); }

TEST(OutputAlpha, NotANumberIsBlack) {
  EXPECT_THAT(alpha_codes({Rgb(std::numeric_limits<float>::quiet_NaN()), 0, 0}), ElementsAre(0, 0, 0, 255));
}

// Chapter 30 §12 I: the first two rows of a slope.
std::array<std::vector<int>, 2> dithered_slope(DitherMethod method) {
  Film film(12, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) {
      const double px = x + 0.5 - 6, py = 4 - (y + 0.5);
      film.at(x, y).rgb = Rgb(static_cast<float>((px + 6.3) / 60 + (py + 4) / 200));
    }
  }
  const EncodedImage image = encoded(film, kLinear, {.dither = method});
  std::array<std::vector<int>, 2> rows;
  for (std::size_t x = 0; x < 12; ++x) {
    rows[0].push_back(image.codes[3 * x]);
    rows[1].push_back(image.codes[3 * (12 + x)]);
  }
  return rows;
}

TEST(Dither, FloydSteinbergAsMeasured) {
  const auto rows = dithered_slope(DitherMethod::kFloydSteinberg);
  EXPECT_THAT(rows[0], ElementsAreArray({64, 73, 82, 89, 96, 103, 108, 114, 119, 124, 128, 133}));
  EXPECT_THAT(rows[1], ElementsAreArray({60, 71, 80, 87, 94, 101, 106, 112, 117, 122, 127, 132}));
}

// Measured with the reference, +THD1: the error at the end of a row goes to the next.
TEST(Dither, OneDimensionalDiffusionRunsOnIntoTheNextRow) {
  const auto rows = dithered_slope(DitherMethod::kDiffusion1);
  EXPECT_THAT(rows[0], ElementsAreArray({64, 73, 82, 89, 97, 102, 108, 114, 119, 124, 128, 133}));
  EXPECT_THAT(rows[1], ElementsAreArray({61, 71, 79, 87, 95, 100, 107, 112, 117, 123, 127, 131}));
}

// Chapter 30 §7.6: {1,3;4,2}/4 - 0.5 steps, the column first, added to 100.25.
TEST(Dither, OrderedTwoByTwo) {
  Film film(2, 2);
  for (const int y : {0, 1}) {
    for (const int x : {0, 1}) film.at(x, y).rgb = Rgb(100.25f / 255);
  }
  const EncodedImage image =
      encoded(film, kLinear, {.dither = DitherMethod::kBayer2, .file_gamma = GammaCurve::linear()});
  std::vector<int> reds;
  for (std::size_t i = 0; i < 4; ++i) reds.push_back(image.codes[3 * i]);
  EXPECT_THAT(reds, ElementsAre(100, 101, 101, 100));
}

}  // namespace
}  // namespace lute
