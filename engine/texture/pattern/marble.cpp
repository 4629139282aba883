#include "engine/texture/pattern/marble.hpp"

#include "engine/texture/noise.hpp"
#include "engine/texture/warp.hpp"

namespace lute {

double evaluate(const Marble&, const dvec3& p, const PatternContext& context) {
  if (context.turbulence == nullptr) return p.x;
  return p.x + context.turbulence->amount.x * turbulence(p, *context.turbulence, context.noise_generator);
}

}  // namespace lute
