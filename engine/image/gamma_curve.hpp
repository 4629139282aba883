// The curves between light and the numbers that files and working spaces store, in single precision as the reference computes.
// Source: specification chapter 30 §7.2.
#pragma once

#include <compare>

namespace lute {

// A curve with its inverse; encode takes light to numbers.
struct GammaCurve {
  enum class Kind { kLinear, kPower, kSrgb };
  Kind kind = Kind::kSrgb;
  double gamma = 1;  // of kPower

  static GammaCurve linear() { return {Kind::kLinear, 1}; }
  static GammaCurve srgb() { return {Kind::kSrgb, 1}; }
  static GammaCurve power(double gamma);  // near 1 (within 1 %) it is linear

  float encode(float light) const;
  float decode(float number) const;
  friend auto operator<=>(const GammaCurve&, const GammaCurve&) = default;
  friend bool operator==(const GammaCurve&, const GammaCurve&) = default;
};

}  // namespace lute
