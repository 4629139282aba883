#include "engine/texture/pattern/wood.hpp"

#include "engine/texture/noise.hpp"
#include "engine/texture/warp.hpp"

namespace lute {

double evaluate(const Wood&, const dvec3& p, const PatternContext& context) {
  dvec2 q{p.x, p.y};
  if (context.turbulence != nullptr) {
    const dvec3 d = vector_turbulence(p, *context.turbulence);
    q.x += cycle_sine((p.x + d.x) * context.turbulence->amount.x);
    q.y += cycle_sine((p.y + d.y) * context.turbulence->amount.y);
  }
  return glm::length(q);
}

}  // namespace lute
