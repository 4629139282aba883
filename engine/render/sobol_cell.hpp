// Owen-scrambled Sobol points of the unit square, addressed by the cell that they lie in.
//
// The first 4^k points of the two-dimensional Sobol sequence lie one in each cell of the 2^k by 2^k grid, and the point
// of a cell is also that of one of its four parts. Adaptive sampling can therefore divide any cell: three new points
// join the one that is there, and whatever is divided to one level is a stratified, scrambled net.
//
// Sources: I. M. Sobol, "On the distribution of points in a cube", 1967; A. B. Owen, "Randomly permuted (t,m,s)-nets
// and (t,s)-sequences", 1995; the permutation of bits after S. Laine and T. Karras, "Stratified sampling for
// stochastic transparency", 2011.
#pragma once

#include <cstdint>

#include "engine/math/vec.hpp"

namespace lute {

class SobolCells {
 public:
  static constexpr int kDeepestLevel = 6;

  // Two seeds give two independent scramblings.
  explicit SobolCells(std::uint64_t seed);

  // The point in [0, 1)² of the cell with this column and row (0 ... 2^level - 1); 0 <= level <= kDeepestLevel.
  dvec2 point(int level, int column, int row) const;

 private:
  std::uint32_t seed_x_, seed_y_;
};

}  // namespace lute
