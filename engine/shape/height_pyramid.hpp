// Least and greatest heights of the cells of a height field, and of ever larger squares of cells.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/shape/height_field.hpp"

namespace lute {

class HeightPyramid {
 public:
  struct Range {
    std::uint16_t lo, hi;
  };

  explicit HeightPyramid(const HeightGrid& grid);

  int levels() const { return static_cast<int>(levels_.size()); }
  // The square of 2^level cells a side at (x, z), counted in such squares; false if there is none.
  bool exists(int level, int x, int z) const {
    const Level& l = levels_[static_cast<std::size_t>(level)];
    return x < l.width && z < l.depth;
  }
  Range range(int level, int x, int z) const {
    const Level& l = levels_[static_cast<std::size_t>(level)];
    return l.ranges[static_cast<std::size_t>(z) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(x)];
  }
  Range all() const { return range(levels() - 1, 0, 0); }

 private:
  struct Level {
    int width, depth;
    std::vector<Range> ranges;
  };
  std::vector<Level> levels_;
};

}  // namespace lute
