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

// Equal to std::fmod(v, 1) for every number: the part after the point, with the sign of v.
inline double fraction(double v) {
  if (!(std::fabs(v) < kAllIntegers)) return std::fmod(v, 1.0);
  return v - static_cast<double>(static_cast<std::int64_t>(v));
}

}  // namespace lute
