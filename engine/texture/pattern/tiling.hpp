// tiling number: 27 tilings of the x-z plane (specification chapter 50 §7).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Tiling : PatternDefaults {
  static constexpr std::string_view kKeyword = "tiling";
  int number = 1;  // 1...27
};

double evaluate(const Tiling& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
