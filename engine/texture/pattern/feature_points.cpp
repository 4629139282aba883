#include "engine/texture/pattern/feature_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/texture/noise.hpp"

namespace lute {
namespace {

struct Offset {
  std::int8_t x, y, z;
};

// All offsets of -2...2 with at most one component of magnitude 2, in the order of the reference's loops.
constexpr auto kOffsets = [] {
  std::array<Offset, 81> offsets{};
  std::size_t count = 0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k)
        if ((i * i == 4) + (j * j == 4) + (k * k == 4) <= 1)
          offsets[count++] = {static_cast<std::int8_t>(i), static_cast<std::int8_t>(j), static_cast<std::int8_t>(k)};
  return offsets;
}();

// Calls visit(feature point) for the 81 cubes around `p`.
template <class Visit>
void for_feature_points(const dvec3& p, Visit&& visit) {
  const dvec3 f{std::floor(p.x - kEpsilon), std::floor(p.y - kEpsilon), std::floor(p.z - kEpsilon)};
  const auto index = [](double c) { return static_cast<std::int64_t>(std::clamp(c, -9e15, 9e15)); };
  const std::int64_t x = index(f.x), y = index(f.y), z = index(f.z);
  const double* random = random_numbers();
  for (const Offset& o : kOffsets) {
    const double* r = random + hash3(x + o.x, y + o.y, z + o.z);
    visit(dvec3(f.x + o.x + r[0], f.y + o.y + r[1], f.z + o.z + r[2]));
  }
}

template <class Distance>
FeaturePoints three_nearest(const dvec3& p, const Distance& distance) {
  const double inf = std::numeric_limits<double>::infinity();
  FeaturePoints n{{inf, inf, inf}, dvec3(0)};
  for_feature_points(p, [&](const dvec3& feature) {
    const double s = distance(p - feature);
    if (!(s < n.distance[2])) return;
    n.distance[2] = s;
    if (s < n.distance[1]) std::swap(n.distance[1], n.distance[2]);
    if (s < n.distance[0]) {
      std::swap(n.distance[0], n.distance[1]);
      n.nearest = feature;
    }
  });
  return n;
}

template <class Distance>
dvec3 nearest_one(const dvec3& p, const Distance& distance) {
  double best = std::numeric_limits<double>::infinity();
  dvec3 nearest{0};
  for_feature_points(p, [&](const dvec3& feature) {
    const double s = distance(p - feature);
    if (s < best) {
      best = s;
      nearest = feature;
    }
  });
  return nearest;
}

double square(const dvec3& d) { return d.x * d.x + d.y * d.y + d.z * d.z; }
double manhattan(const dvec3& d) { return std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z); }

auto powers(double metric) {
  return [metric](const dvec3& d) {
    return std::pow(std::fabs(d.x), metric) + std::pow(std::fabs(d.y), metric) + std::pow(std::fabs(d.z), metric);
  };
}

}  // namespace

FeaturePoints crackle_points(const dvec3& p, double metric) {
  if (metric == 2) return three_nearest(p, square);
  if (metric == 1) return three_nearest(p, manhattan);
  return three_nearest(p, powers(metric));
}

dvec3 facet_point(const dvec3& p, double metric) {
  if (metric == 2) return nearest_one(p, square);
  if (metric == 1) return nearest_one(p, [](const dvec3& d) { return d.x + d.y + d.z; });
  return nearest_one(p, powers(metric));
}

}  // namespace lute
