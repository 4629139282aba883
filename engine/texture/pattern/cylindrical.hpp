// cylindrical: 1 on the y axis falling to 0 at distance 1
//
// Value: 0...1, 1 - √(x² + z²), 0 farther out. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Cylindrical : PatternDefaults {
  static constexpr std::string_view kKeyword = "cylindrical";
};

double evaluate(const Cylindrical& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
