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
  for (double& d : n.distance) {
    if (std::isinf(d)) d = 0;  // not wanted
    if (pattern.offset != 0) d += std::pow(pattern.offset, pattern.metric);
    d = pattern.metric == 2 ? std::sqrt(d) : pattern.metric == 1 ? d : std::pow(d, 1 / pattern.metric);
  }
  const dvec3& form = pattern.form;
  return std::clamp(form.x * n.distance[0] + form.y * n.distance[1] + form.z * n.distance[2], 0.0, 1.0);
}

}  // namespace lute
