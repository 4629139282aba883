// Floors and remainders without a library call: equal to those of the C++ library for every number.
#include "engine/math/rounding.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace lute {
namespace {

std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }

// To the bit, the sign of zero included.
void expect_library_remainder(double v) {
  EXPECT_EQ(bits(within_pattern_period(v)), bits(std::fmod(v, kPatternPeriod))) << v;
}

TEST(PatternPeriod, MultiplesAndTheirNeighboursLeaveTheExactRemainder) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (int turns = 0; turns < 1100000; turns = turns < 5000 ? turns + 1 : turns + turns / 7) {
    double below = turns * kPatternPeriod, above = below;
    for (int i = 0; i < 4; ++i) {
      for (const double v : {below, above, -below, -above}) expect_library_remainder(v);
      below = std::nextafter(below, -kInfinity);
      above = std::nextafter(above, kInfinity);
    }
  }
}

TEST(PatternPeriod, NumbersOfEverySizeLeaveTheExactRemainder) {
  for (int exponent = -60; exponent < 80; ++exponent)
    for (int i = 0; i < 200; ++i) {
      const double v = std::ldexp(1 + std::fmod(i * 0.6180339887498949, 1.0), exponent);
      expect_library_remainder(v);
      expect_library_remainder(-v);
    }
}

TEST(PatternPeriod, ValuesWithinThePeriodStayAsTheyAre) {
  EXPECT_EQ(within_pattern_period(1), 1);
  EXPECT_EQ(within_pattern_period(-0.75), -0.75);
  EXPECT_EQ(bits(within_pattern_period(-0.0)), bits(-0.0));
}

TEST(PatternPeriod, WhatIsNoNumberHasNoRemainder) {
  EXPECT_TRUE(std::isnan(within_pattern_period(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(within_pattern_period(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace lute
