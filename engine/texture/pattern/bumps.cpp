#include "engine/texture/pattern/bumps.hpp"

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Bumps&, const dvec3& p, const PatternContext& context) {
  return noise(p, context.noise_generator);
}

dvec3 perturb(const Bumps&, const dvec3& normal, double amount, const dvec3& p, const PatternContext&) {
  return normal + amount * vector_noise(p);
}

}  // namespace lute
