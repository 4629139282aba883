#include "engine/texture/pattern/crackle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/texture/noise.hpp"

namespace lute {

namespace {

struct Nearest {
  double distance[3];  // sums of |delta|^metric, ascending
  dvec3 point;
};

double distance_sum(const dvec3& d, double metric) {
  if (metric == 2) return glm::dot(d, d);
  if (metric == 1) return std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
  return std::pow(std::fabs(d.x), metric) + std::pow(std::fabs(d.y), metric) + std::pow(std::fabs(d.z), metric);
}

// The three nearest feature points among the 81 cells around the point: all offsets of -2...2 of which at most one
// is 2.
Nearest nearest_points(const dvec3& p, double metric) {
  const double inf = std::numeric_limits<double>::infinity();
  Nearest n{{inf, inf, inf}, dvec3(0)};
  const dvec3 f{std::floor(p.x - kEpsilon), std::floor(p.y - kEpsilon), std::floor(p.z - kEpsilon)};
  const auto index = [](double c) { return static_cast<std::int64_t>(std::clamp(c, -9e15, 9e15)); };
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) {
        if ((i * i == 4) + (j * j == 4) + (k * k == 4) > 1) continue;
        const dvec3 cell = f + dvec3(i, j, k);
        const std::uint32_t h = hash3(index(cell.x), index(cell.y), index(cell.z));
        const dvec3 feature = cell + dvec3(random_table(h), random_table(h + 1), random_table(h + 2));
        const double s = distance_sum(p - feature, metric);
        if (!(s < n.distance[2])) continue;
        n.distance[2] = s;
        if (s < n.distance[1]) std::swap(n.distance[1], n.distance[2]);
        if (s < n.distance[0]) {
          std::swap(n.distance[0], n.distance[1]);
          n.point = feature;
        }
      }
  return n;
}

}  // namespace

double evaluate(const Crackle& pattern, const dvec3& p, const PatternContext& context) {
  const Nearest n = nearest_points(p, pattern.metric);
  double s[3] = {n.distance[0], n.distance[1], n.distance[2]};
  if (pattern.solid) return std::clamp(noise(n.point, context.noise_generator), 0.0, 1.0);
  for (double& d : s) {
    if (pattern.offset != 0) d += std::pow(pattern.offset, pattern.metric);
    d = pattern.metric == 2 ? std::sqrt(d) : pattern.metric == 1 ? d : std::pow(d, 1 / pattern.metric);
  }
  return std::clamp(pattern.form.x * s[0] + pattern.form.y * s[1] + pattern.form.z * s[2], 0.0, 1.0);
}

}  // namespace lute
