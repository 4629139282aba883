#include "engine/texture/pattern/crackle.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/feature_points.hpp"

namespace lute {

double evaluate(const Crackle& pattern, const dvec3& p, const PatternContext& context) {
  const int wanted = pattern.solid ? 1 : pattern.form.z != 0 ? 3 : 2;
  FeaturePoints n = crackle_points(p, pattern.metric, wanted);
  if (pattern.solid) return std::clamp(noise(n.nearest, context.noise_generator), 0.0, 1.0);
  const double further = pattern.offset != 0 ? std::pow(pattern.offset, pattern.metric) : 0;
  double value = 0;
  for (int i = 0; i < 3; ++i) {
    if (pattern.form[i] == 0) continue;
    const double d = n.distance[i] + further;
    value += pattern.form[i] * (pattern.metric == 2 ? std::sqrt(d) : pattern.metric == 1 ? d : std::pow(d, 1 / pattern.metric));
  }
  return std::clamp(value, 0.0, 1.0);
}

}  // namespace lute
