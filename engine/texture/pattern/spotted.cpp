#include "engine/texture/pattern/spotted.hpp"

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Spotted&, const dvec3& p, const PatternContext& context) {
  return noise(p, context.noise_generator);
}

}  // namespace lute
