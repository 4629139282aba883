// quilted { control0 a control1 b }: padded unit cubes
//
// Value: 0 at the middle of a cube, at most 0.58 at its corners with the defaults; not processed by frequency, phase and wave. Normal:
// away from the middle. control0, control1 (both default 1): the two control heights of the cubic from the middle to a corner.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Quilted : PatternDefaults {
  static constexpr std::string_view kKeyword = "quilted";
  static constexpr float kFrequency = 0;
  float control0 = 1, control1 = 1;
};

double evaluate(const Quilted& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Quilted& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
