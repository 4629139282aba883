// agate { agate_turb amount }: a sine along z, disturbed by turbulence
//
// Value: 0...1, ((sin 2π(1.3 t + 1.1 z) + 1) / 2)^0.77 with t = amount · turbulence. agate_turb (default 1) scales the disturbance.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Agate : PatternDefaults {
  static constexpr std::string_view kKeyword = "agate";
  float turbulence = 1;  // agate_turb
};

double evaluate(const Agate& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
