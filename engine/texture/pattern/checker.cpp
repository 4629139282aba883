#include "engine/texture/pattern/checker.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Checker&, const dvec3& p, const PatternContext&) {
  const double sum = fast_floor(p.x + kEpsilon) + fast_floor(p.y + kEpsilon) + fast_floor(p.z + kEpsilon);
  const double half = sum * 0.5;
  return half != fast_floor(half) ? 1 : 0;
}

}  // namespace lute
