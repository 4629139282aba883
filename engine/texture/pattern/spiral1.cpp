#include "engine/texture/pattern/spiral1.hpp"

#include "engine/texture/pattern/spiral.hpp"

namespace lute {

double evaluate(const Spiral1& pattern, const dvec3& p, const PatternContext& context) {
  return spiral_phase(p, pattern.arms, context);
}

}  // namespace lute
