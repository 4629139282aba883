#include "engine/shape/height_pyramid.hpp"

#include <algorithm>

namespace lute {

HeightPyramid::HeightPyramid(const HeightGrid& grid) {
  Level cells{grid.width - 1, grid.depth - 1, {}};
  for (int z = 0; z < cells.depth; ++z) {
    for (int x = 0; x < cells.width; ++x) {
      const auto [lo, hi] = std::minmax({grid.at(x, z), grid.at(x + 1, z), grid.at(x, z + 1), grid.at(x + 1, z + 1)});
      cells.ranges.push_back({static_cast<std::uint16_t>(lo), static_cast<std::uint16_t>(hi)});
    }
  }
  levels_.push_back(std::move(cells));
  while (levels_.back().width > 1 || levels_.back().depth > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.width + 1) / 2, (fine.depth + 1) / 2, {}};
    const int level = levels() - 1;
    for (int z = 0; z < coarse.depth; ++z) {
      for (int x = 0; x < coarse.width; ++x) {
        Range r = range(level, 2 * x, 2 * z);
        for (int child = 1; child < 4; ++child) {
          const int cx = 2 * x + child % 2;
          const int cz = 2 * z + child / 2;
          if (!exists(level, cx, cz)) continue;
          const Range c = range(level, cx, cz);
          r = {std::min(r.lo, c.lo), std::max(r.hi, c.hi)};
        }
        coarse.ranges.push_back(r);
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

}  // namespace lute
