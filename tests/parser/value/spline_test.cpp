// No expected numbers: what is enclosed must hold for points of the range.
#include "parser/value/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/function/enclosure.hpp"

namespace lute {
namespace {

constexpr SplineKind kKinds[] = {SplineKind::kLinear, SplineKind::kQuadratic, SplineKind::kCubic, SplineKind::kNatural};

TEST(SplineEnclosure, HoldsForEveryKindAndNumberOfPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const SplineKind kind : kKinds)
    for (int points = 0; points <= 7; ++points)
      for (int i = 0; i < 60; ++i) {
        Spline spline;
        spline.kind = kind;
        for (int p = 0; p < points; ++p) spline.insert(3 * unit(random), {unit(random), 5 * unit(random)});
        // The argument runs from `from` on with this slope.
        const double from = 4 * unit(random), slope = unit(random), length = i % 3 == 0 ? 0.01 : 4, to = from + slope * length;
        const std::size_t k = i % 2;
        const Enclosure e = spline.enclose({std::min(from, to), std::max(from, to), slope, slope}, k);
        double before = 0;
        constexpr int kSamples = 50;
        for (int sample = 0; sample <= kSamples; ++sample) {
          const double value = spline.evaluate(from + slope * length * sample / kSamples)[k];
          ASSERT_LE(e.lo, value) << "kind " << static_cast<int>(kind) << ", " << points << " points";
          ASSERT_GE(e.hi, value) << "kind " << static_cast<int>(kind) << ", " << points << " points";
          const double quotient = (value - before) * kSamples / length, rounding = 1e-12 * (1 + std::abs(quotient)) * kSamples / length;
          if (sample > 0) {
            ASSERT_LE(e.slope_lo, quotient + rounding) << "kind " << static_cast<int>(kind) << ", " << points << " points";
            ASSERT_GE(e.slope_hi, quotient - rounding) << "kind " << static_cast<int>(kind) << ", " << points << " points";
          }
          before = value;
        }
      }
}

// Between (0, 1) and (2, 5) the line rises by 2 for 1; before it is 1.
TEST(SplineEnclosure, OfALineIsTight) {
  Spline spline;
  spline.insert(0, {1});
  spline.insert(2, {5});
  const Enclosure middle = spline.enclose({0.5, 1, 1, 1}, 0), across = spline.enclose({-1, 1, 1, 1}, 0);
  EXPECT_NEAR(middle.lo, 2, 1e-13);
  EXPECT_NEAR(middle.hi, 3, 1e-13);
  EXPECT_NEAR(middle.slope_lo, 2, 1e-13);
  EXPECT_NEAR(across.lo, 1, 1e-13);
  EXPECT_EQ(across.slope_lo, 0);
  EXPECT_NEAR(across.slope_hi, 2, 1e-13);
}

}  // namespace
}  // namespace lute
