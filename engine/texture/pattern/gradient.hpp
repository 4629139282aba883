// gradient <direction>: the distance along a direction, modulo 1
//
// Value: below 1; above 1 the fractional part of the distance along the direction, negative ones are wrapped later as those of all
// patterns. direction: any vector but 0, kept with length 1.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Gradient : PatternDefaults {
  static constexpr std::string_view kKeyword = "gradient";
  dvec3 direction{0, 1, 0};  // unit
};

double evaluate(const Gradient& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
