// Ten million rays from inside of closed meshes, aimed at edges and corners: none gets out.
//
// The aim is computed in doubles, so a ray passes an edge at a distance of about 1e-16, now on the one side and now on
// the other; where it goes exactly through, both faces must claim it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include "engine/accel/triangle_tree.hpp"

namespace lute {
namespace {

constexpr int kThreads = 2;
constexpr long kRaysOfAThread = 1'250'000;  // for each of four meshes

struct ClosedMesh {
  std::vector<glm::vec3> vertices;
  std::vector<TriangleTree::Face> faces;
};

// The icosahedron, its faces divided `levels` times, corners moved outward or inward at random by up to `rough`, then
// stretched.
ClosedMesh ball(int levels, double rough, const dvec3& stretch) {
  const double phi = (1 + std::sqrt(5.0)) / 2;
  std::vector<dvec3> points{{-1, phi, 0},  {1, phi, 0},  {-1, -phi, 0}, {1, -phi, 0}, {0, -1, phi},  {0, 1, phi},
                            {0, -1, -phi}, {0, 1, -phi}, {phi, 0, -1},  {phi, 0, 1},  {-phi, 0, -1}, {-phi, 0, 1}};
  std::vector<TriangleTree::Face> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(0.5 * (points[a] + points[b]));
      return at->second;
    };
    std::vector<TriangleTree::Face> divided;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      divided.insert(divided.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(divided);
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-rough, rough);
  ClosedMesh mesh;
  for (const dvec3& p : points) {
    const dvec3 moved = glm::normalize(p) * (1 + offset(random));
    mesh.vertices.emplace_back(moved * stretch);
  }
  mesh.faces = std::move(faces);
  return mesh;
}

// A corner in one of four cases, a point of an edge in the others: halves, random parts, and very near to a corner.
dvec3 aim_at(const ClosedMesh& mesh, std::mt19937_64& random) {
  const auto& face = mesh.faces[random() % mesh.faces.size()];
  const std::size_t corner = random() % 3;
  const dvec3 a(mesh.vertices[face[corner]]), b(mesh.vertices[face[(corner + 1) % 3]]);
  switch (random() % 4) {
    case 0:
      return a;
    case 1:
      return 0.5 * (a + b);
    case 2:
      return a + 1e-7 * (b - a);
    default:
      return a + std::uniform_real_distribution<double>(0, 1)(random) * (b - a);
  }
}

long escapes(const ClosedMesh& mesh, const TriangleTree& tree, const dvec3& stretch, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  long escaped = 0;
  for (long i = 0; i < kRaysOfAThread; ++i) {
    const dvec3 from = 0.3 * dvec3(unit(random), unit(random), unit(random)) * stretch;
    const dvec3 aim = aim_at(mesh, random) - from;
    const Ray ray{from, i % 2 == 0 ? aim : glm::normalize(aim)};
    TriangleHit hit;
    escaped += tree.nearest(ray, {0, 1e30}, hit) ? 0 : 1;
  }
  return escaped;
}

void expect_closed(const ClosedMesh& mesh, const dvec3& stretch) {
  const TriangleTree tree(mesh.vertices, mesh.faces, [](std::uint32_t) { return false; });
  std::array<long, kThreads> escaped{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] { escaped[i] = escapes(mesh, tree, stretch, 1000 + i); });
    }
  }
  for (const long count : escaped) EXPECT_EQ(count, 0);
}

TEST(Watertight, SmoothBall) {
  const dvec3 even(1);
  expect_closed(ball(5, 0, even), even);
}

TEST(Watertight, RoughBall) {
  const dvec3 even(1);
  expect_closed(ball(5, 0.1, even), even);
}

TEST(Watertight, NeedleFaces) {
  const dvec3 stretch(1, 1e-4, 1e3);
  expect_closed(ball(4, 0.05, stretch), stretch);
}

TEST(Watertight, FacesOfTheSizeOfADustGrain) {
  const dvec3 tiny(1e-9);
  expect_closed(ball(4, 0.05, tiny), tiny);
}

}  // namespace
}  // namespace lute
