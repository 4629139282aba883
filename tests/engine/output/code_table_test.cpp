#include "engine/output/code_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lute {
namespace {

// The sRGB curve, rounded to `max`: what a table must repeat for every float.
int srgb_code(float v, int max) {
  const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
  return static_cast<int>(std::floor(encoded * static_cast<float>(max) + 0.5f));
}

void expect_same_codes(int max) {
  const CodeTable table([&](float v) { return srgb_code(v, max); }, max);
  for (int code = 1; code <= max; ++code) {
    // The inverse of the curve at the boundary between two codes, and its neighbours.
    const double encoded = (code - 0.5) / max;
    auto v = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    for (int i = 0; i < 4; ++i) v = std::nextafter(v, 0.0f);
    for (int i = 0; i < 9; ++i, v = std::nextafter(v, 1.0f)) ASSERT_EQ(table(v), srgb_code(v, max)) << v;
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const float v = unit(random);
    ASSERT_EQ(table(v), srgb_code(v, max)) << v;
  }
}

TEST(CodeTable, RepeatsTheFunctionAtEveryBoundary) {
  expect_same_codes(31);
  expect_same_codes(255);
}

TEST(CodeTable, ClipsWhatLiesOutside) {
  const CodeTable table([](float v) { return srgb_code(v, 255); }, 255);
  EXPECT_EQ(table(-1), 0);
  EXPECT_EQ(table(0), 0);
  EXPECT_EQ(table(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(table(1), 255);
  EXPECT_EQ(table(std::numeric_limits<float>::infinity()), 255);
}

}  // namespace
}  // namespace lute
