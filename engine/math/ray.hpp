// A ray: points origin + t * direction, t >= 0. The direction of every traced ray has unit length up to rounding, so t is a
// world distance.
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

struct Ray {
  dvec3 origin{0};
  dvec3 direction{0, 0, 1};

  dvec3 at(double t) const { return origin + t * direction; }
};

}  // namespace lute
