// hexagon A, B, C: a tiling of the x-z plane in three colours
//
// Value: 0, 1 or 2; hexagons have side 1. x counts as |x|, so that the tiling is mirrored at x = 0. Not processed by frequency, phase
// and wave. No parameters.
// Source: specification chapter 50 §6.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Hexagon : PatternDefaults {
  static constexpr std::string_view kKeyword = "hexagon";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 3;
};

double evaluate(const Hexagon& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
