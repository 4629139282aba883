#include <gtest/gtest.h>

#include <random>

#include "engine/texture/pattern/pavement_table.hpp"
#include "engine/texture/pattern/polygon_tiling.hpp"
#include "pattern_value.hpp"

namespace lute {
namespace {

// Specification chapter 50 §16 B: grey map, (x, z) = (0.3, 0.8), (-2.4, 1.7), (5.05, -3.3).
void expect_three(const PatternBody& body, double at1, double at2, double at3) {
  EXPECT_NEAR(value_at(body, {0.3, 0, 0.8}), at1, 2e-6);
  EXPECT_NEAR(value_at(body, {-2.4, 0, 1.7}), at2, 2e-6);
  EXPECT_NEAR(value_at(body, {5.05, 0, -3.3}), at3, 2e-6);
}

PatternBody tiling(int number) {
  Tiling t;
  t.number = number;
  return body_of(t);
}

PatternBody pavement(int sides, int tiles, int pattern, int interior, int exterior) {
  Pavement p;
  p.sides = sides;
  p.tiles = tiles;
  p.pattern = pattern;
  p.interior = interior;
  p.exterior = exterior;
  return body_of(p);
}

TEST(Tiling, EqualsTheReference) {
  expect_three(tiling(7), 0.592893, 0.507107, 0.678680);
  expect_three(tiling(21), 0.769936, 0.987564, 0.679818);
  expect_three(tiling(25), 0.405467, 0.726449, 0.205416);
  expect_three(tiling(26), 0.215659, 0.421157, 0.185671);
}

// The polygons leave no gap: every point lies inside some tile or, within rounding, on its edge.
TEST(Tiling, CoversThePlane) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-20, 20);
  for (int number = 1; number <= 24; ++number) {
    const PolygonTiling& t = polygon_tiling(number);
    for (int i = 0; i < 2000; ++i) {
      const dvec2 p(place(random), place(random));
      // In every tile of the plane the point has a twin in the parallelogram: try the tiles at all nearby translates.
      double deepest = -1;
      const dvec2 &u = t.along[0], &v = t.along[1];
      const double determinant = u.x * v.y - u.y * v.x;
      const dvec2 q = p - std::floor((p.x * v.y - p.y * v.x) / determinant) * u - std::floor((u.x * p.y - u.y * p.x) / determinant) * v;
      int holding = 0;
      for (const Tile& tile : t.tiles) {
        double depth = 1e9;
        for (const TileEdge& e : tile.edges) depth = std::min(depth, e.offset - glm::dot(e.outward, q));
        deepest = std::max(deepest, depth);
        holding += depth > 1e-9;
      }
      EXPECT_GT(deepest, -1e-9) << "tiling " << number;
      EXPECT_LE(holding, 1) << "tiling " << number;
    }
  }
}

TEST(Pavement, EqualsTheReference) {
  expect_three(pavement(4, 4, 3, 1, 0), 0.6, 0.4, 0.3);
  expect_three(pavement(6, 3, 2, 0, 0), 0.514359, 0, 0.431535);
  expect_three(pavement(3, 4, 2, 0, 1), 0.514359, 0, 0.431535);
}

// Chapter 50 §8: form counts modulo 4 for squares, otherwise 3; interior and exterior modulo 3.
TEST(Pavement, KindsOfCornersComeAround) {
  for (const int sides : {3, 4, 6})
    for (int kind = 0; kind < 3; ++kind)
      for (const dvec3& p : {dvec3(0.3, 0, 0.8), dvec3(-2.4, 0, 1.7), dvec3(5.05, 0, -3.3)}) {
        Pavement low, high;
        low.sides = high.sides = sides;
        low.tiles = high.tiles = 3;
        low.form = low.interior = low.exterior = kind;
        high.form = kind + (sides == 4 ? 4 : 3);
        high.interior = high.exterior = kind + 3;
        EXPECT_EQ(value_at(body_of(low), p), value_at(body_of(high), p)) << sides << ' ' << kind;
      }
}

// Every cell of every pavement belongs to exactly one tile: so many cells are listed as the lattice's parallelogram holds.
TEST(Pavement, TilesCoverTheLattice) {
  for (const PavementEntry& e : kPavements) {
    int cells = 0;
    for (const char c : e.cells) cells += c >= '0' && c <= '9';
    EXPECT_EQ(cells / 2, e.p * e.q * (e.sides == 3 ? 2 : 1)) << e.sides << ' ' << e.tiles << ' ' << e.pattern;
  }
  EXPECT_EQ(pavement_pattern_count(4, 6), 35);
  EXPECT_EQ(pavement_pattern_count(6, 5), 22);
  EXPECT_EQ(pavement_pattern_count(6, 6), 0);
}

}  // namespace
}  // namespace lute
