#include "engine/texture/pattern/wrinkles.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Wrinkles&, const dvec3& p, const PatternContext& context) {
  std::array<double, 10> octaves;
  octaves_of_noise(p, 1, context.noise_generator, static_cast<int>(octaves.size()), octaves.data());
  double sum = 0;
  double scale = 1;
  for (const double n : octaves) {
    sum += (context.noise_generator == 1 ? n : std::clamp(2 * n - 0.5, 0.0, 1.0)) / scale;
    scale *= 2;
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
