// checker A, B: unit cubes in two colours
//
// Value: 0 or 1, the parity of the sum of the rounded-down coordinates; not processed by frequency, phase and wave. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Checker : PatternDefaults {
  static constexpr std::string_view kKeyword = "checker";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 2;
};

double evaluate(const Checker& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
