// gradient <direction>: the fractional part of the distance along a direction (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Gradient : PatternDefaults {
  static constexpr std::string_view kKeyword = "gradient";
  dvec3 direction{0, 1, 0};  // unit
};

double evaluate(const Gradient& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
