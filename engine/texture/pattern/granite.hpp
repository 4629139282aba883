// granite: six octaves of folded noise
//
// Value: 0 to a little below 1, Σ min(0.5, |1 - 2 noise(4·2^i p)|) / 2^i (noise generator 1: |0.5 - noise|). No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Granite : PatternDefaults {
  static constexpr std::string_view kKeyword = "granite";
};

double evaluate(const Granite& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
