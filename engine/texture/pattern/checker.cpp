#include "engine/texture/pattern/checker.hpp"

#include <cmath>

namespace lute {

double evaluate(const Checker&, const dvec3& p, const PatternContext&) {
  const double sum = std::floor(p.x + kEpsilon) + std::floor(p.y + kEpsilon) + std::floor(p.z + kEpsilon);
  return std::fmod(sum, 2.0) != 0 ? 1 : 0;
}

}  // namespace lute
