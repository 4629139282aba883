#include "engine/texture/pattern/gradient.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Gradient& pattern, const dvec3& p, const PatternContext&) {
  const double g = glm::dot(p, pattern.direction);
  return g > 1 ? fraction(g) : g;
}

}  // namespace lute
