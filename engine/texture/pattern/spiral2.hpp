// spiral2 arms: a spiral around the z axis crossed with rings
//
// Value: 0...2, the triangle wave of the distance from the axis plus that of the spiral's phase (engine/texture/pattern/spiral.hpp),
// made a triangle wave once more later. arms: 16 bits, may be negative.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Spiral2 : PatternDefaults {
  static constexpr std::string_view kKeyword = "spiral2";
  static constexpr Wave kWave = Wave::kTriangle;
  int arms = 1;
};

double evaluate(const Spiral2& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
