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

}  // namespace
}  // namespace lute
