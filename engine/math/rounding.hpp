// Floor without a call: on the baseline instruction set std::floor is a library function, and patterns need it several times a point.
#pragma once

#include <cmath>
#include <cstdint>

namespace lute {

// Beyond this every double is an integer (or not a number).
inline constexpr double kAllIntegers = 4503599627370496.0;

// Equal to std::floor for every number (0 for -0).
inline double fast_floor(double v) {
  if (!(std::fabs(v) < kAllIntegers)) return v;
  const double t = static_cast<double>(static_cast<std::int64_t>(v));
  return t > v ? t - 1 : t;
}

// Within +-limit; what is not a number becomes -limit. The one rule for numbers that scenes bring to where an integer is made of them.
inline double bounded(double v, double limit) { return v > -limit ? (v < limit ? v : limit) : -limit; }

// A whole number as an integer. Beyond 9e15 cells are meaningless, but must not be undefined.
inline std::int64_t cell_number(double v) { return static_cast<std::int64_t>(bounded(v, 9e15)); }

// Equal to std::fmod(v, 1) for every number: the part after the point, with the sign of v.
inline double fraction(double v) {
  if (!(std::fabs(v) < kAllIntegers)) return std::fmod(v, 1.0);
  return v - static_cast<double>(static_cast<std::int64_t>(v));
}

// The period of every pattern's value: a little above 1, so that a raw value of exactly 1 survives (chapter 50 §4).
inline constexpr double kPatternPeriod = 1.00001;

// Equal to std::fmod(v, kPatternPeriod) for every number. The period is taken in two parts: whole multiples of either are exact as long as
// there are fewer than 2^20, and so are both differences, which have no bits below those of v or of the period.
inline double within_pattern_period(double v) {
  constexpr double kHigh = static_cast<double>(static_cast<float>(kPatternPeriod)), kLow = kPatternPeriod - kHigh;
  const double size = std::fabs(v);
  if (size < kPatternPeriod) return v;
  if (!(size < 1048576)) return std::fmod(v, kPatternPeriod);
  const double turns = static_cast<double>(static_cast<std::int64_t>(size / kPatternPeriod));
  double rest = (size - turns * kHigh) - turns * kLow;
  if (rest < 0) rest += kPatternPeriod;  // the quotient was rounded up to a whole number
  return std::copysign(rest, v);
}

}  // namespace lute
