#include "engine/texture/noise.hpp"

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "engine/texture/warp.hpp"

namespace lute {
namespace {

const dvec3 kP1{0.25, 0.5, 0.75}, kP2{-1.3, 2.7, 0.4}, kP3{17.1, -5.6, 33.3};

// Specification chapter 50 §16 A, rows bozo noise_generator 1, 2, 3.
TEST(Noise, EqualsTheReferenceForEveryGenerator) {
  const double expected[3][3] = {{0.583792462646, 0.894231881306, 0.173446306891},
                                 {0.556580287584, 0.708650843572, 0.355569834972},
                                 {0.688600535850, 0.487471524708, 0.477359193796}};
  for (int g = 1; g <= 3; ++g) {
    EXPECT_NEAR(noise(kP1, g), expected[g - 1][0], 1e-12);
    EXPECT_NEAR(noise(kP2, g), expected[g - 1][1], 1e-12);
    EXPECT_NEAR(noise(kP3, g), expected[g - 1][2], 1e-12);
  }
}

// Chapter 10 §14, check case 6: vturbulence(2,0.5,6,<0.3,0.7,1.1>).
TEST(Noise, VectorTurbulenceEqualsTheReference) {
  const dvec3 v = vector_turbulence({0.3, 0.7, 1.1}, Turbulence{.octaves = 6, .omega = 0.5f, .lambda = 2});
  EXPECT_NEAR(v.x, 0.344564, 5e-7);
  EXPECT_NEAR(v.y, -0.261187, 5e-7);
  EXPECT_NEAR(v.z, -0.078804, 5e-7);
}

// Chapter 50 §3: the noise of generator 2 doubled less a half, clamped for the first octave alone.
TEST(Noise, TurbulenceIsTheSumOfItsOctaves) {
  const Turbulence t{.octaves = 4, .omega = 0.7f, .lambda = 2.5f};
  double sum = std::clamp(2 * noise(kP2, 2) - 0.5, 0.0, 1.0), l = t.lambda, o = t.omega;
  dvec3 vector_sum = vector_noise(kP2);
  for (int i = 0; i < 3; ++i, l *= t.lambda, o *= t.omega) {
    sum += o * (2 * noise(kP2 * l, 2) - 0.5);
    vector_sum += o * vector_noise(kP2 * l);
  }
  EXPECT_NEAR(turbulence(kP2, t, 2), sum, 1e-14);
  EXPECT_LT(glm::length(vector_turbulence(kP2, t) - vector_sum), 1e-14);
}

// Against the long sine of cycles folded without rounding: all quarters, their ends, both signs, near 0 and far away.
TEST(CycleSine, IsThatOfTheFractionToTheLastBits) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-4, 4);
  std::vector<double> cycles{0, 0.25, 0.5, 0.75, 1, 1.25, 1e15 + 0.25, 1e300, 0.5 - 0x1p-54, 0.5 + 0x1p-53, 1 - 0x1p-53, 0x1p-1000};
  for (int i = 0; i < 20000; ++i) cycles.push_back(std::ldexp(any(random), i % 60 - 40));
  for (const double size : cycles) {
    for (const double v : {size, -size}) {
      const long double turned = std::fabs(v) - std::floor(std::fabs(v));
      const long double half = std::min(turned, 1 - turned), quarter = std::min(half, 0.5L - half);
      const long double expected = std::copysign(1.0L, turned > 0.5L ? -v : v) * std::sin(2 * std::numbers::pi_v<long double> * quarter);
      const double rounded = static_cast<double>(expected);
      EXPECT_NEAR(cycle_sine(v), rounded, 2 * std::numeric_limits<double>::epsilon() * std::fabs(rounded)) << v;
    }
  }
  EXPECT_TRUE(std::isnan(cycle_sine(std::numeric_limits<double>::infinity())));
}

// A picture must not depend on the processor.
TEST(Noise, IsTheSameToTheLastBitOnEveryInstructionSet) {
  const auto evaluate_all = [] {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-50, 50);
    std::vector<double> values;
    for (int i = 0; i < 2000; ++i) {
      const dvec3 p(coordinate(random), coordinate(random), coordinate(random));
      const dvec3 v = vector_noise(p), t = vector_turbulence(p, Turbulence{});
      values.insert(values.end(), {noise(p, 1), noise(p, 2), v.x, v.y, v.z, turbulence(p, Turbulence{}, 1),
                                   turbulence(p, Turbulence{}, 2), t.x, t.y, t.z});
    }
    return values;
  };
  const auto expected = evaluate_all();
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t one = rest & -rest;
    if ((one & HWY_TARGETS) == 0) continue;
    hwy::SetSupportedTargetsForTest(one);
    EXPECT_EQ(evaluate_all(), expected) << hwy::TargetName(one);
  }
  hwy::SetSupportedTargetsForTest(0);
}

// Chapter 30 §5.1: first and last entries.
TEST(Noise, HashTableEqualsTheReference) {
  EXPECT_EQ(hash_table(0), 2291u);
  EXPECT_EQ(hash_table(15), 669u);
  EXPECT_EQ(hash_table(4095), 3088u);
}

// MT19937 with seed 5489 begins with 3499211612 (Matsumoto and Nishimura's reference output).
TEST(Noise, RandomTableIsMersenneTwister) { EXPECT_EQ(random_table(0), 3499211612.0 / 4294967296.0); }

TEST(Noise, FarAwayCoordinatesAreDefined) {
  for (int g = 1; g <= 3; ++g) {
    const double n = noise({1e17, -1e17, 1e12}, g);
    EXPECT_GE(n, 0);
    EXPECT_LE(n, 1);
  }
}

}  // namespace
}  // namespace lute
