#include "engine/texture/pattern/crackle.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/feature_points.hpp"

namespace lute {

double evaluate(const Crackle& pattern, const dvec3& p, const PatternContext& context) {
  if (pattern.solid) return std::clamp(noise(crackle_points(p, pattern.metric, 1).nearest, context.noise_generator), 0.0, 1.0);
  const int wanted = pattern.form.z != 0 ? 3 : pattern.form.y != 0 ? 2 : 1;
  const dvec3 distance = crackle_distances(p, pattern.metric, wanted);
  const double further = pattern.offset != 0 ? std::pow(pattern.offset, pattern.metric) : 0;
  double value = 0;
  for (int i = 0; i < 3; ++i) {
    if (pattern.form[i] == 0) continue;
    const double d = distance[i] + further;
    value += pattern.form[i] * (pattern.metric == 2 ? std::sqrt(d) : pattern.metric == 1 ? d : std::pow(d, 1 / pattern.metric));
  }
  return std::clamp(value, 0.0, 1.0);
}

}  // namespace lute
