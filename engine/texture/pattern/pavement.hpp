// pavement { number_of_sides 3|4|6 number_of_tiles n pattern p form f interior i exterior e }: pavings of the x-z plane by tiles of
// triangles, squares or hexagons
//
// Value: 0...1, 1 on the edges of tiles. Cells have side 1. sides (default 3), tiles (1): cells in a tile; pattern (1): 1 to
// pavement_pattern_count(). form, interior, exterior (0): how corners of tiles are drawn; the last two count modulo 3, form modulo 4
// for squares, otherwise 3.
// Source: specification chapter 50 §8.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Pavement : PatternDefaults {
  static constexpr std::string_view kKeyword = "pavement";
  int sides = 3;
  int tiles = 1;
  int pattern = 1;
  int form = 0, interior = 0, exterior = 0;
};

double evaluate(const Pavement& pattern, const dvec3& point, const PatternContext& context);

// How many patterns a number of tiles has; 0: none, the numbers are an error.
int pavement_pattern_count(int sides, int tiles);

}  // namespace lute
