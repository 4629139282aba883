// square A, B, C, D: unit squares of the x-z plane in four colours
//
// Value: 0...3 by the parities of the rounded-down x and z; not processed by frequency, phase and wave. No parameters.
// Source: specification chapter 50 §6.3.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Square : PatternDefaults {
  static constexpr std::string_view kKeyword = "square";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 4;
};

double evaluate(const Square& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
