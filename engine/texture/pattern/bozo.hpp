// bozo: plain noise
//
// Value: the noise at the point, 0...1. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Bozo : PatternDefaults {
  static constexpr std::string_view kKeyword = "bozo";
};

double evaluate(const Bozo& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
