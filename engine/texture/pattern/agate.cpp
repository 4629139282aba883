#include "engine/texture/pattern/agate.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"
#include "engine/texture/warp.hpp"

namespace lute {

double evaluate(const Agate& pattern, const dvec3& p, const PatternContext& context) {
  const Turbulence standard;
  const double t = pattern.turbulence * turbulence(p, context.turbulence != nullptr ? *context.turbulence : standard,
                                                   context.noise_generator);
  const double v = std::clamp((cycle_sine(1.3 * t + 1.1 * p.z) + 1) / 2, 0.0, 1.0);
  return v < 1 ? std::pow(v, 0.77) : 1.0;
}

}  // namespace lute
