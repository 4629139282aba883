#include "engine/texture/pattern/bozo.hpp"

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Bozo&, const dvec3& p, const PatternContext& context) {
  return noise(p, context.noise_generator);
}

}  // namespace lute
