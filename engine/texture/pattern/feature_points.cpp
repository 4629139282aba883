#include "engine/texture/pattern/feature_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/math/rounding.hpp"
#include "engine/texture/noise.hpp"

namespace lute {
namespace {

struct Offset {
  std::int8_t x, y, z;
};

// All offsets of -2...2 with at most one component of magnitude 2, nearer ones first: the nearest points are found early, and
// cubes that are farther away than those need no look.
constexpr auto kOffsets = [] {
  std::array<Offset, 81> offsets{};
  std::size_t count = 0;
  for (int distance2 = 0; distance2 <= 6; ++distance2)
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        for (int k = -2; k <= 2; ++k)
          if ((i * i == 4) + (j * j == 4) + (k * k == 4) <= 1 && i * i + j * j + k * k == distance2)
            offsets[count++] = {static_cast<std::int8_t>(i), static_cast<std::int8_t>(j), static_cast<std::int8_t>(k)};
  return offsets;
}();

// The cubes around a point.
class Cubes {
 public:
  explicit Cubes(const dvec3& p)
      : point(p), cube(fast_floor(p.x - kEpsilon), fast_floor(p.y - kEpsilon), fast_floor(p.z - kEpsilon)) {
    const auto low = [](double c) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(c, -9e15, 9e15)) & 4095); };
    y_ = low(cube.y);
    z_ = low(cube.z);
    for (std::uint32_t i = 0; i < 5; ++i) hash_x_[i] = hash_[(low(cube.x) + i - 2) & 4095];
  }

  dvec3 feature(const Offset& o) const {
    const auto step = [](std::uint32_t c, int by) { return (c + static_cast<std::uint32_t>(by)) & 4095; };
    const double* r = random_ + hash_[hash_[hash_x_[static_cast<std::size_t>(o.x + 2)] ^ step(y_, o.y)] ^ step(z_, o.z)];
    return {cube.x + o.x + r[0], cube.y + o.y + r[1], cube.z + o.z + r[2]};
  }

  const dvec3 point, cube;

 private:
  const std::uint16_t* hash_ = hash_numbers();
  const double* random_ = random_numbers();
  std::uint32_t hash_x_[5], y_, z_;
};

// power(d): |d|^metric of one component; the distance is the sum over the components. `grows`: it grows with |d|.
template <class Power>
FeaturePoints nearest_points(const dvec3& p, int wanted, const Power& power, bool grows = true) {
  const Cubes cubes(p);
  // At least so far away is everything in the cubes at an offset along an axis.
  double least[3][5];
  for (int axis = 0; axis < 3; ++axis) {
    const double in_cube = p[axis] - cubes.cube[axis];
    for (int o = -2; o <= 2; ++o)
      least[axis][o + 2] = o == 0 || !grows ? 0 : power(std::max(o > 0 ? o - in_cube : in_cube - (o + 1), 0.0));
  }
  const double inf = std::numeric_limits<double>::infinity();
  FeaturePoints n{{inf, inf, inf}, dvec3(0)};
  for (const Offset& o : kOffsets) {
    constexpr double kRounding = 1 - 1e-9;
    if ((least[0][o.x + 2] + least[1][o.y + 2] + least[2][o.z + 2]) * kRounding > n.distance[wanted - 1]) continue;
    const dvec3 feature = cubes.feature(o), d = p - feature;
    const double s = power(d.x) + power(d.y) + power(d.z);
    if (!(s < n.distance[2])) continue;
    n.distance[2] = s;
    if (s < n.distance[1]) std::swap(n.distance[1], n.distance[2]);
    if (s < n.distance[0]) {
      std::swap(n.distance[0], n.distance[1]);
      n.nearest = feature;
    }
  }
  return n;
}

dvec3 nearest_by_signed_sum(const dvec3& p) {
  const Cubes cubes(p);
  double best = std::numeric_limits<double>::infinity();
  dvec3 nearest{0};
  for (const Offset& o : kOffsets) {
    const dvec3 feature = cubes.feature(o), d = p - feature;
    const double s = d.x + d.y + d.z;
    if (s >= best) continue;
    best = s;
    nearest = feature;
  }
  return nearest;
}

}  // namespace

FeaturePoints crackle_points(const dvec3& p, double metric, int wanted) {
  if (metric == 2) return nearest_points(p, wanted, [](double d) { return d * d; });
  if (metric == 1) return nearest_points(p, wanted, [](double d) { return std::fabs(d); });
  return nearest_points(p, wanted, [metric](double d) { return std::pow(std::fabs(d), metric); }, metric > 0);
}

dvec3 facet_point(const dvec3& p, double metric) { return metric == 1 ? nearest_by_signed_sum(p) : crackle_points(p, metric, 1).nearest; }

}  // namespace lute
