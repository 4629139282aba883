#include "engine/texture/pattern/square.hpp"

#include <cmath>

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Square&, const dvec3& p, const PatternContext&) {
  const bool x_even = std::fmod(fast_floor(p.x), 2.0) == 0, z_even = std::fmod(fast_floor(p.z), 2.0) == 0;
  if (x_even) return z_even ? 0 : 1;
  return z_even ? 3 : 2;
}

}  // namespace lute
