#include "engine/texture/pattern/leopard.hpp"

#include <cmath>

namespace lute {

double evaluate(const Leopard&, const dvec3& p, const PatternContext&) {
  const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
  return mean * mean;
}

}  // namespace lute
