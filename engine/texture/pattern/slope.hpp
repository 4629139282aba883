// slope <direction>, slope { [point_at] <vector>, low, high altitude <vector>, low, high }: how steep a surface is
//
// Value: 0...1, the angle of the normal (perturbed so far) with the direction: 0 against it, 1 along it; 0 where there is no surface.
// low, high (default 0: none) stretch that part of the range to 0...1. altitude mixes in the height along its vector, weighted by the
// lengths of the two vectors. The pattern's transformations move the altitude only.
// Source: specification chapter 50 §6.7.
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
