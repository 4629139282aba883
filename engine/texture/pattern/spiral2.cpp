#include "engine/texture/pattern/spiral2.hpp"

#include <cmath>

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/spiral.hpp"

namespace lute {

double evaluate(const Spiral2& pattern, const dvec3& p, const PatternContext& context) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  return triangle_wave(rho) + triangle_wave(spiral_phase(p, pattern.arms, context));
}

}  // namespace lute
