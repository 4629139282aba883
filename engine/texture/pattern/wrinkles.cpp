#include "engine/texture/pattern/wrinkles.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Wrinkles&, const dvec3& p, const PatternContext& context) {
  double sum = 0;
  double scale = 1;
  for (int i = 0; i < 10; ++i, scale *= 2) {
    const double n = noise(p * scale, context.noise_generator);
    sum += (context.noise_generator == 1 ? n : std::clamp(2 * n - 0.5, 0.0, 1.0)) / scale;
  }
  return sum / 2;
}

dvec3 perturb(const Wrinkles&, const dvec3& normal, double amount, const dvec3& p, const PatternContext&) {
  dvec3 sum{0};
  double scale = 1;
  for (int i = 0; i < 10; ++i, scale *= 2) sum += glm::abs(vector_noise(p * scale)) / scale;
  return normal + amount * sum;
}

}  // namespace lute
