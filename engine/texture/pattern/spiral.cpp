#include "engine/texture/pattern/spiral.hpp"

#include <cmath>

#include "engine/texture/noise.hpp"
#include "engine/texture/warp.hpp"

namespace lute {

double spiral_phase(const dvec3& p, int arms, const PatternContext& context) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  double phi = 0;
  if (rho != 0) phi = p.x < 0 ? 1.5 * kPi - std::asin(p.y / rho) : 0.5 * kPi + std::asin(p.y / rho);
  double phase = p.z + rho + arms * phi / (2 * kPi);
  if (context.turbulence != nullptr)
    phase += context.turbulence->amount.x * turbulence(p, *context.turbulence, context.noise_generator);
  return phase;
}

}  // namespace lute
