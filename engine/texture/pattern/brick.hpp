// brick mortar, brick { brick_size <x, y, z> mortar thickness }: a wall of bricks, every second course shifted by half a brick
//
// Value: 0 in the mortar, 1 in a brick; not processed by frequency, phase and wave. brick_size (default <8, 3, 4.5>) is the distance
// from one brick to the next, mortar (default 0.5) the gap between them.
// Source: specification chapter 50 §6.1.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Brick : PatternDefaults {
  static constexpr std::string_view kKeyword = "brick";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 2;  // mortar, brick
  dvec3 size{8, 3, 4.5};
  float mortar = 0.5f;
};

double evaluate(const Brick& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
