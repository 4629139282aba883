#include "engine/accel/triangle_tree.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lute {
namespace {

using Random = std::mt19937;

double signed_unit(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }
dvec3 in_cube(Random& random) { return {signed_unit(random), signed_unit(random), signed_unit(random)}; }

struct Surface {
  std::vector<glm::vec3> vertices;
  std::vector<TriangleTree::Face> faces;
  TriangleTree tree() const {
    return TriangleTree(vertices, faces, [](std::uint32_t) { return false; });
  }
  void triangle(const dvec3& a, const dvec3& b, const dvec3& c) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const dvec3& p : {a, b, c}) vertices.emplace_back(p);
    faces.push_back({first, first + 1, first + 2});
  }
};

// A closed, bumpy ball of 2 (rings - 1) segments triangles that share their vertices.
Surface ball(std::uint32_t rings, std::uint32_t segments, double scale) {
  Surface s;
  Random random(5);
  for (std::uint32_t r = 0; r <= rings; ++r)
    for (std::uint32_t k = 0; k < segments; ++k) {
      const double theta = kPi * r / rings, phi = 2 * kPi * k / segments;
      const double radius = scale * (r == 0 || r == rings ? 1 : 1 + 0.05 * signed_unit(random));
      s.vertices.emplace_back(radius *
                              dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)));
    }
  const auto at = [&](std::uint32_t r, std::uint32_t k) {
    return r == 0 ? 0 : r == rings ? rings * segments : r * segments + k % segments;
  };
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t k = 0; k < segments; ++k) {
      if (r > 0) s.faces.push_back({at(r, k), at(r, k + 1), at(r + 1, k)});
      if (r + 1 < rings) s.faces.push_back({at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)});
    }
  return s;
}

TEST(TriangleTree, NearestIsTheLeastOfAllAndAnyAgrees) {
  Random random(1);
  for (int exponent = -8; exponent <= 8; exponent += 4) {
    const double scale = std::pow(10.0, exponent);
    Surface s;
    for (int i = 0; i < 500; ++i) {
      const dvec3 p = scale * in_cube(random);
      s.triangle(p, p + 0.3 * scale * in_cube(random), p + 0.3 * scale * in_cube(random));
    }
    const TriangleTree tree = s.tree();
    std::vector<TriangleTree> oracles;  // one for each triangle
    for (std::uint32_t f = 0; f < s.faces.size(); ++f)
      oracles.emplace_back(s.vertices, s.faces, [f](std::uint32_t face) { return face != f; });
    int hit_count = 0;
    for (int i = 0; i < 2000; ++i) {
      const dvec3 origin = 2.0 * scale * in_cube(random);
      const Ray ray{origin, glm::normalize(scale * in_cube(random) - origin)};
      const Interval range{0, 3 * scale};
      std::vector<TriangleHit> oracle;
      for (const TriangleTree& one : oracles) one.all(ray, range, oracle);
      std::vector<TriangleHit> all;
      tree.all(ray, range, all);
      ASSERT_EQ(all.size(), oracle.size());
      EXPECT_EQ(tree.any(ray, range), !oracle.empty());
      TriangleHit nearest;
      ASSERT_EQ(tree.nearest(ray, range, nearest), !oracle.empty());
      if (oracle.empty()) continue;
      ++hit_count;
      const auto least =
          std::min_element(oracle.begin(), oracle.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
      EXPECT_EQ(nearest.t, least->t);
      EXPECT_EQ(nearest.face, least->face);
      dvec3 point(0);
      for (std::size_t c = 0; c < 3; ++c) point += nearest.weights[c] * dvec3(s.vertices[s.faces[nearest.face][c]]);
      EXPECT_LT(glm::distance(point, ray.at(nearest.t)), 1e-12 * scale);
    }
    EXPECT_GT(hit_count, 200);
  }
}

TEST(TriangleTree, NoRayPassesBetweenTriangles) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Surface s = ball(40, 80, scale);
    const TriangleTree tree = s.tree();
    Random random(2);
    int through = 0;
    for (int i = 0; i < 700000; ++i) {
      // From inside at points of an edge, as exactly as double precision can aim.
      const auto& face = s.faces[random() % s.faces.size()];
      const dvec3 a(s.vertices[face[0]]), b(s.vertices[face[1]]);
      const double share = i % 10 == 0 ? 0 : std::uniform_real_distribution<double>(0, 1)(random);
      const dvec3 origin = 0.5 * scale * in_cube(random);
      const Ray ray{origin, glm::normalize(a + share * (b - a) - origin)};
      if (!tree.any(ray, {0, 1e10})) ++through;
      TriangleHit hit;
      if (!tree.nearest(ray, {0, 1e10}, hit)) ++through;
    }
    EXPECT_EQ(through, 0) << scale;
  }
}

TEST(TriangleTree, CrossingsTellInsideFromOutsideEvenThroughEdgesAndCorners) {
  // A cube of 12 triangles; the rays meet corners, edges and the diagonals of the faces exactly.
  Surface s;
  for (int corner = 0; corner < 8; ++corner)
    s.vertices.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  for (const std::array<std::uint32_t, 4>& q : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                                                {4, 5, 7, 6},
                                                {0, 1, 5, 4},
                                                {2, 3, 7, 6},
                                                {0, 2, 6, 4},
                                                {1, 3, 7, 5}}) {
    s.faces.push_back({q[0], q[1], q[2]});
    s.faces.push_back({q[0], q[2], q[3]});
  }
  const TriangleTree tree = s.tree();
  for (double x = -1.5; x <= 1.5; x += 0.5)
    for (double y = -1.5; y <= 1.5; y += 0.5)
      for (double z = -1.5; z <= 1.5; z += 0.5) {
        const dvec3 p(x, y, z);
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 1) continue;  // on the surface
        const bool inside = std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1;
        for (const dvec3& direction : {dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(1, 1, 0), dvec3(1, 1, 1),
                                       dvec3(-1, 1, 1), dvec3(2, 1, 0)})
          EXPECT_EQ(tree.crossings({p, direction}, {0, 1e10}) % 2 == 1, inside)
              << x << ' ' << y << ' ' << z << " along " << direction.x << ' ' << direction.y << ' ' << direction.z;
      }
}

TEST(TriangleTree, HitsAreBitIdenticalOnEveryInstructionSet) {
  const Surface s = ball(30, 60, 1);
  const auto trace_all = [&] {
    const TriangleTree tree = s.tree();
    Random random(4);
    std::vector<TriangleHit> hits;
    for (int i = 0; i < 20000; ++i) {
      const dvec3 origin = 2.0 * in_cube(random);
      const Ray ray{origin, glm::normalize(in_cube(random) - origin)};
      TriangleHit hit;
      if (tree.nearest(ray, {1e-4, 1e7}, hit)) hits.push_back(hit);
    }
    return hits;
  };
  const auto expected = trace_all();
  EXPECT_GT(expected.size(), 5000u);
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t one = rest & -rest;
    if ((one & HWY_TARGETS) == 0) continue;
    hwy::SetSupportedTargetsForTest(one);
    const auto actual = trace_all();
    ASSERT_EQ(actual.size(), expected.size()) << hwy::TargetName(one);
    for (std::size_t i = 0; i < actual.size(); ++i) {
      ASSERT_EQ(actual[i].t, expected[i].t) << hwy::TargetName(one);
      ASSERT_EQ(actual[i].face, expected[i].face) << hwy::TargetName(one);
      ASSERT_EQ(actual[i].weights, expected[i].weights) << hwy::TargetName(one);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(TriangleTree, HighestFaceWinsExactTies) {
  Surface s;
  for (int i = 0; i < 50; ++i) s.triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  TriangleHit hit;
  ASSERT_TRUE(s.tree().nearest({{0, 0, -1}, {0, 0, 1}}, {0, 10}, hit));
  EXPECT_EQ(hit.face, 49u);
}

TEST(TriangleTree, SkippedAndUnboundedFacesAreNeverHit) {
  Surface s;
  s.triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  s.triangle({-1, -1, 1}, {1, -1, 1}, {0, std::numeric_limits<double>::infinity(), 1});
  const Ray ray{{0, 0, -1}, {0, 0, 1}};
  TriangleHit hit;
  EXPECT_FALSE(TriangleTree(s.vertices, s.faces, [](std::uint32_t f) { return f == 0; }).nearest(ray, {0, 10}, hit));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(s.tree().nearest({dvec3(nan), dvec3(nan)}, {0, 10}, hit));
  EXPECT_FALSE(s.tree().any({dvec3(0), dvec3(nan)}, {0, nan}));
}

}  // namespace
}  // namespace lute
