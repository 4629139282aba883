#include "engine/texture/pattern/granite.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Granite&, const dvec3& p, const PatternContext& context) {
  double sum = 0;
  double scale = 4, weight = 1;
  for (int i = 0; i < 6; ++i, scale *= 2, weight *= 0.5) {
    const double n = noise(p * scale, context.noise_generator);
    const double a = context.noise_generator == 1 ? std::fabs(0.5 - n) : std::min(0.5, std::fabs(1 - 2 * n));
    sum += a * weight;
  }
  return sum;
}

}  // namespace lute
