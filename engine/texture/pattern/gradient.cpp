#include "engine/texture/pattern/gradient.hpp"

#include <cmath>

namespace lute {

double evaluate(const Gradient& pattern, const dvec3& p, const PatternContext&) {
  const double g = glm::dot(p, pattern.direction);
  return g > 1 ? std::fmod(g, 1.0) : g;
}

}  // namespace lute
