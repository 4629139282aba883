// triangular A ... F: a tiling of the x-z plane by triangles in six colours
//
// Value: 0...5; triangles have side 1. Not processed by frequency, phase and wave. No parameters.
// Source: specification chapter 50 §6.3.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Triangular : PatternDefaults {
  static constexpr std::string_view kKeyword = "triangular";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 6;
};

double evaluate(const Triangular& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
