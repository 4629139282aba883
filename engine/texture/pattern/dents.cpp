#include "engine/texture/pattern/dents.hpp"

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Dents&, const dvec3& p, const PatternContext& context) {
  const double n = noise(p, context.noise_generator);
  return n * n * n;
}

dvec3 perturb(const Dents& pattern, const dvec3& normal, double amount, const dvec3& p, const PatternContext& context) {
  return normal + amount * evaluate(pattern, p, context) * vector_noise(p);
}

}  // namespace lute
