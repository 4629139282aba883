#include "engine/accel/bvh.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

namespace lute {
namespace {

using Random = std::mt19937;

double signed_unit(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }
dvec3 in_cube(Random& random) { return {signed_unit(random), signed_unit(random), signed_unit(random)}; }

// The exact answer, in extended precision: does the ray meet the closed box in [range.lo, range.hi]?
bool meets_exactly(const Ray& ray, Interval range, const Aabb& box) {
  long double lo = range.lo, hi = range.hi;
  for (int a = 0; a < 3; ++a) {
    const long double o = ray.origin[a], d = ray.direction[a];
    if (d == 0) {
      if (o < box.lo[a] || o > box.hi[a]) return false;
      continue;
    }
    const long double t0 = (box.lo[a] - o) / d, t1 = (box.hi[a] - o) / d;
    lo = std::max(lo, std::min(t0, t1));
    hi = std::min(hi, std::max(t0, t1));
  }
  return lo <= hi;
}

std::set<std::uint32_t> visited(const Bvh& bvh, const Ray& ray, Interval range) {
  std::set<std::uint32_t> items;
  std::uint64_t box_tests = 0;
  bvh.traverse(ray, range, box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t i = first; i < first + count; ++i) items.insert(bvh.order()[i]);
    return false;
  });
  return items;
}

void expect_none_lost(const std::vector<Aabb>& boxes, const Bvh& bvh, const Ray& ray, Interval range) {
  const auto items = visited(bvh, ray, range);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (meets_exactly(ray, range, boxes[i])) {
      ASSERT_TRUE(items.contains(i)) << i;
    }
}

TEST(Bvh, LosesNoBoxAtAnyScale) {
  Random random(1);
  for (int exponent = -8; exponent <= 8; exponent += 2) {
    const double scale = std::pow(10.0, exponent);
    std::vector<Aabb> boxes;
    for (int i = 0; i < 200; ++i) {
      const dvec3 a = scale * in_cube(random);
      Aabb box;
      box.join(a);
      box.join(a + scale * 0.1 * in_cube(random));
      if (i % 4 == 0) box.hi[i % 3] = box.lo[i % 3];  // flat
      if (i % 10 == 0) box.hi = box.lo;               // a point
      boxes.push_back(box);
    }
    const Bvh bvh(boxes);
    for (int i = 0; i < 1500; ++i) {
      const Aabb& target = boxes[static_cast<std::size_t>(i) % boxes.size()];
      const dvec3 origin = 3 * scale * in_cube(random);
      // At corners, to graze as often as possible.
      const Ray ray{origin, glm::normalize((i % 2 == 0 ? target.lo : target.hi) - origin)};
      expect_none_lost(boxes, bvh, ray, {0, 1e10});
    }
  }
}

TEST(Bvh, LosesNoBoxFarFromTheOriginOfCoordinates) {
  Random random(2);
  const dvec3 center(1e6, -3e6, 2e6);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 300; ++i) {
    const dvec3 a = center + in_cube(random);
    boxes.push_back({a, a + 0.01});
  }
  const Bvh bvh(boxes);
  std::size_t visits = 0;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 origin = center + 3.0 * in_cube(random);
    const Ray ray{origin, glm::normalize(boxes[static_cast<std::size_t>(i) % 300].lo - origin)};
    expect_none_lost(boxes, bvh, ray, {0, 1e10});
    visits += visited(bvh, ray, {0, 1e10}).size();
  }
  EXPECT_LT(visits, 3000u);  // boxes kept in single precision of the far coordinates would be 0.25 wide: hundreds a ray
}

TEST(Bvh, RaysAlongFacesAndWithTinyDirectionsLoseNothing) {
  std::vector<Aabb> boxes;
  for (int x = -2; x < 2; ++x)
    for (int y = -2; y < 2; ++y)
      for (int z = -2; z < 2; ++z) boxes.push_back({dvec3(x, y, z), dvec3(x + 1, y + 1, z + 1)});
  for (int x = -2; x < 2; ++x) boxes.push_back({dvec3(x, 0, -2), dvec3(x + 1, 0, 2)});  // flat
  const Bvh bvh(boxes);
  for (const double tiny : {0.0, -0.0, 5e-324, -5e-324, 1e-310, 1e-200, -1e-200, 1e-40, -1e-40, 1e-30, -1e-20})
    for (const double start : {-2.0, -1.0, 0.0, 1.0, 2.0, 0.5})
      for (int axis = 0; axis < 3; ++axis) {
        dvec3 direction(tiny), origin(start);
        direction[axis] = start > 0 ? -1 : 1;
        origin[axis] = start > 0 ? 5 : -5;
        expect_none_lost(boxes, bvh, {origin, direction}, {0, 1e10});
      }
}

TEST(Bvh, NanRaysEnd) {
  const std::vector<Aabb> boxes(20, Aabb{dvec3(-1), dvec3(1)});
  const Bvh bvh(boxes);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    visited(bvh, {dvec3(bad), dvec3(0, 0, 1)}, {0, 1e10});
    visited(bvh, {dvec3(0, 0, -5), dvec3(0, bad, 1)}, {0, 1e10});
    visited(bvh, {dvec3(bad), dvec3(bad)}, {bad, bad});
  }
}

// One item on one spot after another defeats every split; the depth stays bounded all the same.
TEST(Bvh, ManyEqualAndGeometricallySpacedItemsStayWithinTheStack) {
  std::vector<Aabb> boxes(1000, Aabb{dvec3(1), dvec3(1)});
  for (int i = 0; i < 200; ++i) {
    const dvec3 p(std::ldexp(1.0, -i / 4), 0, 0);
    boxes.push_back({p, p});
  }
  const Bvh bvh(boxes);
  EXPECT_EQ(visited(bvh, {dvec3(-1, 0, 0), dvec3(1, 0, 0)}, {0, 10}).size(), 200u);
  EXPECT_EQ(visited(bvh, {dvec3(0), glm::normalize(dvec3(1))}, {0, 10}).contains(0), true);
}

TEST(Bvh, IsTheSameForAnyNumberOfThreads) {
  Random random(3);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 200000; ++i) {
    const dvec3 a = in_cube(random);
    boxes.push_back({a, a + 0.01});
  }
  const auto build = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Bvh(boxes);
  };
  const Bvh one = build(1), many = build(4);
  ASSERT_EQ(one.nodes().size(), many.nodes().size());
  EXPECT_EQ(std::memcmp(one.nodes().data(), many.nodes().data(), one.nodes().size_bytes()), 0);
  EXPECT_TRUE(std::equal(one.order().begin(), one.order().end(), many.order().begin(), many.order().end()));
}

TEST(Bvh, WithoutItemsVisitsNothing) {
  EXPECT_TRUE(visited(Bvh(), Ray(), {0, 1}).empty());
  EXPECT_TRUE(visited(Bvh(std::vector<Aabb>(3)), Ray(), {0, 1}).empty());
}

}  // namespace
}  // namespace lute
