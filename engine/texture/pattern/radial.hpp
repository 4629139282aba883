// radial: the angle around the y axis
//
// Value: 0.25...1.25, 0.25 + (atan2(x, z) + π) / 2π, wrapped later as that of all patterns; 0.25 on the axis. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Radial : PatternDefaults {
  static constexpr std::string_view kKeyword = "radial";
};

double evaluate(const Radial& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
