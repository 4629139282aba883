#include "engine/texture/pattern/radial.hpp"

#include <cmath>

namespace lute {

double evaluate(const Radial&, const dvec3& p, const PatternContext&) {
  if (std::fabs(p.x) < 0.001 && std::fabs(p.z) < 0.001) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + kPi) / (2 * kPi);
}

}  // namespace lute
