// slope <direction>, slope { [point_at] <vector>, low, high altitude <vector>, low, high } (specification chapter 50 §6.7).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Slope : PatternDefaults {
  static constexpr std::string_view kKeyword = "slope";
  dvec3 vector{0, 1, 0};  // as written: a direction, or the point that the surface faces
  bool point_at = false;
  double low = 0, high = 0;  // equal: not rescaled
  dvec3 altitude{0};         // zero: none
  double altitude_low = 0, altitude_high = 0;
};

double evaluate(const Slope& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
