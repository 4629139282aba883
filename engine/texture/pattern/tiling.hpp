// tiling number: 27 tilings of the x-z plane
//
// Value: 0...1; each of a tiling's N classes of tiles has a band 1 / N wide, from the middle of a tile to its edge. Edges have length 1
// but for 13, 14 and Penrose's tilings 25 to 27. number: 1...27, others are errors of the parser.
// Source: specification chapter 50 §7.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Tiling : PatternDefaults {
  static constexpr std::string_view kKeyword = "tiling";
  int number = 1;  // 1...27
};

double evaluate(const Tiling& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
