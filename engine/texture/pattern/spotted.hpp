// spotted: plain noise, as bozo
//
// Value: the noise at the point, 0...1. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Spotted : PatternDefaults {
  static constexpr std::string_view kKeyword = "spotted";
};

double evaluate(const Spotted& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
