// hexagon A, B, C: a tiling of the x-z plane in three colours (specification chapter 50 §6.2).
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
