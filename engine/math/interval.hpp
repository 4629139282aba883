// A closed interval of ray depths, [lo, hi] in world units along a unit direction.
#pragma once

#include <limits>

namespace lute {

struct Interval {
  double lo = 0;
  double hi = std::numeric_limits<double>::infinity();

  bool contains(double t) const { return lo <= t && t <= hi; }
  bool empty() const { return !(lo <= hi); }
};

}  // namespace lute
