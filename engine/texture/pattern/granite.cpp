#include "engine/texture/pattern/granite.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Granite&, const dvec3& p, const PatternContext& context) {
  std::array<double, 6> octaves;
  octaves_of_noise(p, 4, context.noise_generator, static_cast<int>(octaves.size()), octaves.data());
  double sum = 0;
  double weight = 1;
  for (const double n : octaves) {
    const double a = context.noise_generator == 1 ? std::fabs(0.5 - n) : std::min(0.5, std::fabs(1 - 2 * n));
    sum += a * weight;
    weight *= 0.5;
  }
  return sum;
}

}  // namespace lute
