#include "engine/render/antialias.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/render/render.hpp"

namespace lute {
namespace {

constexpr int kWidth = 40, kHeight = 36;

// Chapter 30 §12 E: an orthographic view, 4 by 3.6 units, of a slope in red, stripes in green and rings in blue.
class CaseE final : public PixelSource {
 public:
  Color sample(dvec2 p) override {
    const double x = 4 * ((p.x + 0.5) / kWidth - 0.5), y = 3.6 * (0.5 - (p.y + 0.5) / kHeight);
    const double stripes = std::fmod(x * 1.3 + y + 20, 1) < 0.5 ? 0 : 0.6;
    const double rings = std::fmod(std::abs(x * x + y * y), 1);
    return {{static_cast<float>(x / 20 + 0.5), static_cast<float>(stripes), static_cast<float>(rings)}, 0, 0};
  }
};

Film picture(const Antialiasing& antialiasing) {
  RenderSettings settings;
  settings.area = area_of({}, kWidth, kHeight);
  settings.antialiasing = antialiasing;
  Film film(kWidth, kHeight);
  render(
      settings, [] { return std::make_unique<CaseE>(); }, film);
  return film;
}

void expect_pixels(const Antialiasing& antialiasing, const std::array<std::array<int, 3>, 5>& expected) {
  const Film film = picture(antialiasing);
  const std::array<std::array<int, 2>, 5> pixels{{{0, 0}, {3, 5}, {31, 31}, {8, 33}, {32, 20}}};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Color& color = film.at(pixels[i][0], pixels[i][1]);
    EXPECT_NEAR(color.rgb.r * 65535, expected[i][0], 1.5) << i;
    EXPECT_NEAR(color.rgb.g * 65535, expected[i][1], 1.5) << i;
    EXPECT_NEAR(color.rgb.b * 65535, expected[i][2], 1.5) << i;
  }
}

TEST(Antialias, OffTakesThePixelCentre) {
  expect_pixels({.method = 0},
                {{{26378, 0, 56688}, {27361, 0, 18677}, {36536, 0, 9503}, {28999, 39321, 47513}, {36863, 0, 40959}}});
}

TEST(Antialias, MethodOneWithDefaults) {
  expect_pixels({.method = 1},
                {{{26373, 0, 50572}, {27363, 0, 18370}, {36532, 0, 9066}, {29002, 31457, 47262}, {36853, 0, 40697}}});
}

TEST(Antialias, MethodOneWithoutJitter) {
  expect_pixels({.method = 1, .threshold = 0.05f, .depth = 2, .jitter = 0},
                {{{26378, 0, 43646}, {27361, 0, 18743}, {36536, 0, 9568}, {28999, 31457, 47578}, {36863, 0, 41025}}});
}

TEST(Antialias, MethodOneDeeperWithHalfJitter) {
  expect_pixels({.method = 1, .depth = 4, .jitter = 0.5f},
                {{{26376, 0, 41635}, {27360, 0, 18795}, {36540, 0, 13714}, {28999, 32382, 47769}, {36867, 0, 41227}}});
}

TEST(Antialias, MethodTwoWithDefaults) {
  expect_pixels(
      {.method = 2},
      {{{26378, 0, 43755}, {27360, 614, 18742}, {36536, 0, 14641}, {28997, 31334, 47805}, {36863, 0, 41287}}});
}

TEST(Antialias, MethodTwoDeeper) {
  expect_pixels(
      {.method = 2, .threshold = 0.1f, .depth = 4},
      {{{26378, 0, 44827}, {27361, 154, 18707}, {36537, 0, 16077}, {28999, 32102, 47683}, {36862, 0, 41084}}});
}

// Measured with POV-Ray 3.7.0.10, as the cases above: +AM2 +A +R1.
TEST(Antialias, MethodTwoOfDepthOneIsTheMeanOfTheCorners) {
  expect_pixels(
      {.method = 2, .depth = 1},
      {{{26378, 0, 40632}, {27361, 9830, 19005}, {36536, 0, 26214}, {28999, 29491, 47841}, {36863, 0, 41287}}});
}

// A corner is one sample for all of its pixels in a block; here the picture is one block.
TEST(Antialias, MethodTwoOfDepthOneTracesCornersAlone) {
  int samples = 0;
  class Counted final : public PixelSource {
   public:
    explicit Counted(int& samples) : samples_(samples) {}
    Color sample(dvec2 p) override {
      ++samples_;
      EXPECT_EQ(p - glm::floor(p), dvec2(0.5)) << "neither moved nor inside a pixel";
      return CaseE().sample(p);
    }

   private:
    int& samples_;
  } source(samples);
  const Antialiasing settings{.method = 2, .threshold = 0, .depth = 1};
  Film film(kWidth, kHeight);
  render_block(area_of({}, kWidth, kHeight), settings, ColorMetric(settings, GammaMode::kPower, 1), source, film);
  EXPECT_EQ(samples, (kWidth + 1) * (kHeight + 1));
}

// The rings at (0, 0) are bright, where an exponent of 1/5 makes steps small; those at (31, 31) are dark.
// Measured with POV-Ray 3.7.0.10: +A +AG5, +AM2 +A +AG1, +AM2 +A +AG5.
TEST(Antialias, GammaDecidesWhatDiffers) {
  expect_pixels({.method = 1, .gamma = 5},
                {{{26378, 0, 56688}, {27363, 0, 18370}, {36532, 0, 9066}, {29002, 31457, 47262}, {36853, 0, 40697}}});
  expect_pixels(
      {.method = 2, .gamma = 1},
      {{{26376, 0, 43818}, {27363, 614, 18583}, {36534, 0, 14666}, {28997, 31334, 47805}, {36861, 0, 41049}}});
  expect_pixels(
      {.method = 2, .gamma = 5},
      {{{26378, 0, 40632}, {27360, 614, 18742}, {36534, 0, 14666}, {28997, 31334, 47805}, {36863, 0, 41287}}});
}

float encoded(float value, double gamma, GammaMode mode = GammaMode::kPower, double assumed_gamma = 1) {
  return ColorMetric({.gamma = gamma}, mode, assumed_gamma).encode({{value, value, value}, 0, 0}).rgb.g;
}

// Chapter 30 §6: the exponent is that of the scene's working space over the antialiasing gamma; an sRGB working space is decoded
// first (0.5 there is 0.21404 of light); raw values are encoded as they are.
TEST(ColorMetric, EncodesFromTheWorkingSpace) {
  EXPECT_FLOAT_EQ(encoded(0.25f, 2), 0.5f);
  EXPECT_FLOAT_EQ(encoded(0.5f, 2.5, GammaMode::kPower, 2.5), 0.5f);
  EXPECT_FLOAT_EQ(encoded(0.5f, 1, GammaMode::kPower, 2), 0.25f);
  EXPECT_NEAR(encoded(0.5f, 2, GammaMode::kSrgb), std::sqrt(0.21404), 1e-5);
  EXPECT_FLOAT_EQ(encoded(0.25f, 2, GammaMode::kNone, 2.2), 0.5f);
}

TEST(ColorMetric, GammaBelowZeroOrNearOneEncodesNothing) {
  for (const double gamma : {-1.0, 0.0, 0.992, 1.0, 1.009}) EXPECT_EQ(encoded(0.3f, gamma), 0.3f) << gamma;
  EXPECT_LT(encoded(0.3f, 0.98), 0.3f);
  EXPECT_GT(encoded(0.3f, 1.02), 0.3f);
}

TEST(ColorMetric, KeepsWhatIsAboveWhiteAndTransmit) {
  const Color color = ColorMetric({.gamma = 2}, GammaMode::kPower, 1).encode({{4, -1, 0}, 0, 0.25f});
  EXPECT_FLOAT_EQ(color.rgb.r, 2);
  EXPECT_EQ(color.rgb.g, 0);
  EXPECT_EQ(color.transmit, 0.25f);
}

// 3 (0.2^0.4 - 0.1^0.4) = 0.3816, and 0.3 without encoding.
TEST(ColorMetric, DiffersFromTheThresholdOn) {
  const auto differ = [](double gamma, float threshold) {
    const ColorMetric metric({.threshold = threshold, .gamma = gamma}, GammaMode::kPower, 1);
    return metric.differ(metric.encode({Rgb(0.1f), 0, 0}), metric.encode({Rgb(0.2f), 0, 0}));
  };
  EXPECT_TRUE(differ(2.5, 0.381f));
  EXPECT_FALSE(differ(2.5, 0.382f));
  EXPECT_TRUE(differ(1, 0.299f));
  EXPECT_FALSE(differ(1, 0.301f));
}

}  // namespace
}  // namespace lute
