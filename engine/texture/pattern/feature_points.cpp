#include "engine/texture/pattern/feature_points.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
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

std::uint32_t low_bits(double c) { return static_cast<std::uint32_t>(cell_number(c) & 4095); }

// A point and its cube.
struct Place {
  dvec3 point, cube;
  explicit Place(const dvec3& p) : point(p), cube(fast_floor(p.x - kEpsilon), fast_floor(p.y - kEpsilon), fast_floor(p.z - kEpsilon)) {}
  // The cubes of a block of 3 x 3 x 3 differ in its last five bits.
  std::uint64_t number() const { return last_bits(cube.x) + 3 * last_bits(cube.y) + 9 * last_bits(cube.z); }

 private:
  // The whole number's bits stand at the end of such a sum. Far away they are lost, which costs time alone.
  static std::uint64_t last_bits(double c) { return std::bit_cast<std::uint64_t>(c + 1.5 * kAllIntegers); }
};

// The cubes around a point.
class Cubes {
 public:
  explicit Cubes(const Place& place) : point(place.point), cube(place.cube), y_(low_bits(cube.y)), z_(low_bits(cube.z)) {
    for (std::uint32_t i = 0; i < 5; ++i) hash_x_[i] = hash_[(low_bits(cube.x) + i - 2) & 4095];
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

// The smallest distances so far. Of equal ones the first found stays in front.
struct Nearest {
  FeaturePoints points;
  Nearest() {
    const double inf = std::numeric_limits<double>::infinity();
    points = {{inf, inf, inf}, dvec3(0)};
  }
  // True if the distance was among the three.
  bool add(double s, const dvec3& feature) {
    auto& d = points.distance;
    if (!(s < d[2])) return false;
    d[2] = s;
    if (s < d[1]) std::swap(d[1], d[2]);
    if (s < d[0]) {
      std::swap(d[0], d[1]);
      points.nearest = feature;
    }
    return true;
  }
};

// Two doubles of one register.
using Two = double __attribute__((vector_size(16)));

// The smaller one; `b` if `a` is not a number.
template <class T>
T smaller(T a, T b) { return a < b ? a : b; }
template <class T>
T larger(T a, T b) { return a > b ? a : b; }

// The smallest `wanted` of the numbers seen, ascending, in each lane of T, without a branch.
template <class T, int wanted>
struct Smallest {
  T d[wanted];
  explicit Smallest(double start) {
    for (T& each : d) each = T{} + start;
  }
  void add(T v) {
    for (int i = 0; i < wanted; ++i) {
      const T passed_on = larger(v, d[i]);
      d[i] = smaller(v, d[i]);
      v = passed_on;
    }
  }
  void add(const Smallest& other) {
    for (int i = 0; i < wanted; ++i) add(other.d[i]);
  }
};

// The cheap powers, of one distance or two.
struct Square {
  template <class T>
  T operator()(T d) const { return d * d; }
};
struct Magnitude {
  double operator()(double d) const { return std::fabs(d); }
  Two operator()(Two d) const { return larger(d, -d); }
};

// |d|^metric without pow, for multiples of 1/2.
struct HalfPower {
  int whole;
  bool root;
  double operator()(double d) const {
    const double a = std::fabs(d);
    double v = root ? std::sqrt(a) : 1;
    for (int i = 0; i < whole; ++i) v *= a;
    return v;
  }
};
constexpr double kLargestHalfPower = 8;

// What a metric makes of a distance along an axis; grows with it.
template <class Power>
concept DistancePower = requires(const Power& power, double d) {
  { power(d) } -> std::same_as<double>;
};

// At least so far away, along an axis, is everything in the cubes at each offset.
struct LeastDistances {
  double along[3][5];
  explicit LeastDistances(const Cubes& cubes) {
    for (int axis = 0; axis < 3; ++axis) {
      const double in_cube = cubes.point[axis] - cubes.cube[axis];
      for (int o = -2; o <= 2; ++o)
        along[axis][o + 2] = o == 0 ? 0 : std::max(o > 0 ? o - in_cube : in_cube - (o + 1), 0.0);
    }
  }
};

constexpr double kRounding = 1 + 1e-9;

// For powers that are cheap: cubes that are too far away by the metric itself are passed over.
template <DistancePower Power>
FeaturePoints nearest_by_metric(const Cubes& cubes, int wanted, const Power& power) {
  LeastDistances least(cubes);
  for (auto& axis : least.along)
    for (double& d : axis) d = power(d);
  Nearest nearest;
  for (const Offset& o : kOffsets) {
    const double least_sum = least.along[0][o.x + 2] + least.along[1][o.y + 2] + least.along[2][o.z + 2];
    if (least_sum > nearest.points.distance[wanted - 1] * kRounding) continue;
    const dvec3 feature = cubes.feature(o), d = cubes.point - feature;
    nearest.add(power(d.x) + power(d.y) + power(d.z), feature);
  }
  return nearest.points;
}

// For powers that are dear: a point whose distance along one axis alone is too large needs none.
template <DistancePower Power>
FeaturePoints nearest_by_axis(const Cubes& cubes, int wanted, const Power& power, double metric) {
  const LeastDistances least(cubes);
  Nearest nearest;
  double radius = std::numeric_limits<double>::infinity();
  for (const Offset& o : kOffsets) {
    if (std::max({least.along[0][o.x + 2], least.along[1][o.y + 2], least.along[2][o.z + 2]}) > radius) continue;
    const dvec3 feature = cubes.feature(o), d = cubes.point - feature, a = glm::abs(d);
    if (std::max({a.x, a.y, a.z}) > radius) continue;
    if (nearest.add(power(d.x) + power(d.y) + power(d.z), feature))
      radius = std::pow(nearest.points.distance[wanted - 1], 1 / metric) * kRounding;
  }
  return nearest.points;
}

// Metrics that do not grow with the distance.
FeaturePoints nearest_of_all(const Cubes& cubes, double metric) {
  Nearest nearest;
  for (const Offset& o : kOffsets) {
    const dvec3 feature = cubes.feature(o), d = cubes.point - feature;
    nearest.add(std::pow(std::fabs(d.x), metric) + std::pow(std::fabs(d.y), metric) + std::pow(std::fabs(d.z), metric), feature);
  }
  return nearest.points;
}

// Feature points of the cubes kOffsets[first] ... , laid out for a loop without branches: as many as whole vectors hold, those beyond
// the last infinitely far away.
template <std::size_t first, std::size_t count>
struct PointBlock {
  static constexpr std::size_t kLength = (count + 3) / 4 * 4;
  alignas(64) double x[kLength] = {}, y[kLength] = {}, z[kLength] = {};

  void fill(const Cubes& cubes) {
    std::fill(x, x + kLength, std::numeric_limits<double>::infinity());
    std::fill(y, y + kLength, 0.0);
    std::fill(z, z + kLength, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      const dvec3 feature = cubes.feature(kOffsets[first + i]);
      x[i] = feature.x;
      y[i] = feature.y;
      z[i] = feature.z;
    }
  }

  // The distances first, all at once, then the smallest of them.
  template <DistancePower Power>
  void add_to(Nearest& nearest, const dvec3& p, const Power& power) const {
    alignas(64) double distance[kLength];
    for (std::size_t i = 0; i < kLength; ++i) distance[i] = power(p.x - x[i]) + power(p.y - y[i]) + power(p.z - z[i]);
    for (std::size_t i = 0; i < count; ++i)
      if (distance[i] < nearest.points.distance[2]) nearest.add(distance[i], {x[i], y[i], z[i]});
  }

  // The distances alone. Even and odd pairs are kept apart, so that one need not wait for the other.
  template <int wanted, class Power>
  void add_to(Smallest<Two, wanted>& even, Smallest<Two, wanted>& odd, const dvec3& p, const Power& power) const {
    const auto distance = [&](std::size_t i) {
      const auto along = [&](const double* of, double from) {
        Two v;
        std::memcpy(&v, of + i, sizeof v);
        return power(from - v);
      };
      return along(x, p.x) + along(y, p.y) + along(z, p.z);
    };
    for (std::size_t i = 0; i < kLength; i += 4) {
      even.add(distance(i));
      odd.add(distance(i + 2));
    }
  }

  // For powers that are dear: only of what is within `radius` along every axis, which shrinks with what is found.
  template <DistancePower Power>
  void add_within(Nearest& nearest, double& radius, const dvec3& p, int wanted, const Power& power, double metric) const {
    alignas(64) double farthest[kLength];
    for (std::size_t i = 0; i < kLength; ++i) {
      const double dx = std::fabs(p.x - x[i]), dy = std::fabs(p.y - y[i]), dz = std::fabs(p.z - z[i]);
      const double xy = dx > dy ? dx : dy;
      farthest[i] = xy > dz ? xy : dz;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (farthest[i] > radius) continue;
      const dvec3 feature{x[i], y[i], z[i]}, d = p - feature;
      if (nearest.add(power(d.x) + power(d.y) + power(d.z), feature))
        radius = std::pow(nearest.points.distance[wanted - 1], 1 / metric) * kRounding;
    }
  }
};

// The smallest of all lanes.
template <int wanted>
inline Smallest<double, wanted> smallest(Smallest<Two, wanted> even, const Smallest<Two, wanted>& odd) {
  even.add(odd);
  Smallest<double, wanted> all(std::numeric_limits<double>::infinity());
  for (int i = 0; i < wanted; ++i) all.d[i] = even.d[i][0];
  for (int i = 0; i < wanted; ++i) all.add(even.d[i][1]);
  return all;
}

// The cube with its 26 neighbours, and the cubes around those, which are at least 1 away whatever the metric: they are needed
// seldom.
constexpr std::size_t kInner = 27;

class CubePoints {
 public:
  void fill(const Place& place) {
    inner_.fill(Cubes(place));
    outer_filled_ = false;
  }

  template <DistancePower Power>
  FeaturePoints nearest(const Place& place, int wanted, const Power& power) {
    Nearest nearest;
    inner_.add_to(nearest, place.point, power);
    if (nearest.points.distance[wanted - 1] > 1) outer(place).add_to(nearest, place.point, power);
    return nearest.points;
  }
  template <int wanted, class Power>
  dvec3 distances(const Place& place, const Power& power) {
    Smallest<Two, wanted> even(std::numeric_limits<double>::infinity()), odd = even;
    inner_.add_to(even, odd, place.point, power);
    Smallest<double, wanted> all = smallest(even, odd);
    if (all.d[wanted - 1] > 1 && all.d[wanted - 1] * kRounding >= power(nearest_outer(place))) {
      outer(place).add_to(even, odd, place.point, power);
      all = smallest(even, odd);
    }
    dvec3 result(std::numeric_limits<double>::infinity());
    for (int i = 0; i < wanted; ++i) result[i] = all.d[i];
    return result;
  }
  template <DistancePower Power>
  FeaturePoints nearest(const Place& place, int wanted, const Power& power, double metric) {
    Nearest nearest;
    double radius = std::numeric_limits<double>::infinity();
    inner_.add_within(nearest, radius, place.point, wanted, power, metric);
    if (nearest.points.distance[wanted - 1] > 1) outer(place).add_within(nearest, radius, place.point, wanted, power, metric);
    return nearest.points;
  }

 private:
  using Outer = PointBlock<kInner, kOffsets.size() - kInner>;

  // No point of the outer cubes is less far away along some axis.
  static double nearest_outer(const Place& place) {
    double least = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double in_cube = place.point[axis] - place.cube[axis];
      least = smaller(least, smaller(in_cube, 1 - in_cube));
    }
    return 1 + larger(least, 0.0);
  }

  const Outer& outer(const Place& place) {
    if (!outer_filled_) outer_.fill(Cubes(place));
    outer_filled_ = true;
    return outer_;
  }

  PointBlock<0, kInner> inner_;
  Outer outer_;
  bool outer_filled_ = false;
};

// Remembers the points around cubes that are asked for again and again: neighbouring pixels mostly see the same cube. A cube is
// filled when it is asked for the second time in a row, because a single question needs fewer points.
class CubeMemory {
 public:
  CubePoints* find(const Place& place) {
    Entry& entry = entries_[place.number() % kEntries];
    if (entry.asked == 0 || entry.cube.x != place.cube.x || entry.cube.y != place.cube.y || entry.cube.z != place.cube.z) {
      entry.cube = place.cube;
      entry.asked = 1;
      return nullptr;
    }
    if (entry.asked == 1) {
      entry.points.fill(place);
      entry.asked = 2;
    }
    return &entry.points;
  }

 private:
  static constexpr std::size_t kEntries = 32;  // 64 KiB
  struct Entry {
    dvec3 cube{0};
    int asked = 0;
    CubePoints points;
  };
  Entry entries_[kEntries];
};

// Of this thread: what is remembered never changes a result.
constinit thread_local CubeMemory cube_memory;

template <DistancePower Power>
FeaturePoints nearest_cheaply(const Place& place, int wanted, const Power& power) {
  if (CubePoints* points = cube_memory.find(place)) return points->nearest(place, wanted, power);
  return nearest_by_metric(Cubes(place), wanted, power);
}

template <int wanted, DistancePower Power>
dvec3 distances_cheaply(const Place& place, const Power& power) {
  if (CubePoints* points = cube_memory.find(place)) return points->distances<wanted>(place, power);
  const FeaturePoints n = nearest_by_metric(Cubes(place), wanted, power);
  return {n.distance[0], n.distance[1], n.distance[2]};
}

template <DistancePower Power>
dvec3 distances_cheaply(const Place& place, int wanted, const Power& power) {
  if (wanted == 1) return distances_cheaply<1>(place, power);
  if (wanted == 2) return distances_cheaply<2>(place, power);
  return distances_cheaply<3>(place, power);
}

template <DistancePower Power>
FeaturePoints nearest_dearly(const Place& place, int wanted, const Power& power, double metric) {
  // Below 1 the distance along one axis says little.
  if (metric < 1) return nearest_by_metric(Cubes(place), wanted, power);
  if (CubePoints* points = cube_memory.find(place)) return points->nearest(place, wanted, power, metric);
  return nearest_by_axis(Cubes(place), wanted, power, metric);
}

dvec3 nearest_by_signed_sum(const dvec3& p) {
  const Cubes cubes{Place(p)};
  double best = std::numeric_limits<double>::infinity();
  dvec3 nearest{0};
  for (const Offset& o : kOffsets) {
    const dvec3 feature = cubes.feature(o), d = feature - p;
    const double s = d.x + d.y + d.z;
    if (s >= best) continue;
    best = s;
    nearest = feature;
  }
  return nearest;
}

}  // namespace

FeaturePoints crackle_points(const dvec3& p, double metric, int wanted) {
  const Place place(p);
  if (metric == 2) return nearest_cheaply(place, wanted, Square{});
  if (metric == 1) return nearest_cheaply(place, wanted, Magnitude{});
  if (!(metric > 0)) return nearest_of_all(Cubes(place), metric);
  const double halves = 2 * metric;
  if (metric <= kLargestHalfPower && halves == fast_floor(halves))
    return nearest_dearly(place, wanted, HalfPower{static_cast<int>(metric), static_cast<int>(halves) % 2 != 0}, metric);
  return nearest_dearly(place, wanted, [metric](double d) { return std::pow(std::fabs(d), metric); }, metric);
}

dvec3 crackle_distances(const dvec3& p, double metric, int wanted) {
  if (metric == 2) return distances_cheaply(Place(p), wanted, Square{});
  if (metric == 1) return distances_cheaply(Place(p), wanted, Magnitude{});
  const FeaturePoints n = crackle_points(p, metric, wanted);
  return {n.distance[0], n.distance[1], n.distance[2]};
}

dvec3 facet_point(const dvec3& p, double metric) { return metric == 1 ? nearest_by_signed_sum(p) : crackle_points(p, metric, 1).nearest; }

}  // namespace lute
