// Expected numbers: specification chapter 21 §12, check cases named at each test.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "engine/shape/bicubic_patch.hpp"
#include "engine/shape/height_field.hpp"
#include "engine/shape/julia_fractal.hpp"
#include "engine/shape/polygon.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kZ(0, 0, 1), kDown(0, -1, 0);

// Check case 3.
TEST(Polygon, BordersBelongByTheCrossingRule) {
  const auto shape = make(Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}});
  EXPECT_TRACE(*shape, dvec3(1, 0, -5), kZ, dvec3(1, 0, 0), kZ);
  EXPECT_TRUE(trace(*shape, {1, 2, -5}, kZ));
  EXPECT_FALSE(trace(*shape, {0, 1, -5}, kZ));
  // The reference misses this border, which no reading of its rule explains in exact arithmetic: there the last bits of its frame
  // decide. Ours belongs, as the border opposite does not.
  EXPECT_TRUE(trace(*shape, {2, 1, -5}, kZ));
  EXPECT_FALSE(trace(*shape, {2.0000001, 1, -5}, kZ));
  const auto reversed = make(Polygon{{{0, 2, 0}, {2, 2, 0}, {2, 0, 0}, {0, 0, 0}, {0, 2, 0}}});
  EXPECT_TRACE(*reversed, dvec3(1, 1, -5), kZ, dvec3(1, 1, 0), -kZ);
}

TEST(Polygon, SubPolygonsAlternate) {
  const auto shape = make(Polygon{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}}});
  EXPECT_FALSE(trace(*shape, {1.5, 1.5, -5}, kZ));
  EXPECT_TRUE(trace(*shape, {.5, 1.5, -5}, kZ));
  Polygon star;
  for (int i = 0; i < 5; ++i) star.points.push_back({std::sin(4 * kPi * i / 5), std::cos(4 * kPi * i / 5), 0});
  EXPECT_FALSE(polygon_is_closed(star));
  EXPECT_FALSE(trace(*make(star), {0, 0, -5}, kZ));
  EXPECT_TRUE(trace(*make(star), {0, .8, -5}, kZ));
}

TEST(Polygon, BentOneIsNeverHit) {
  EXPECT_FALSE(trace(*make(Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 2, .001}, {0, 2, 0}, {0, 0, 0}}}), {1, 1, -5}, kZ));
}

BicubicPatch wavy(double flatness, int steps) {
  BicubicPatch patch;
  patch.flatness = flatness;
  patch.u_steps = patch.v_steps = steps;
  const double z[4][4] = {{1.5, .5, -.5, -2}, {0, 1, -1, .5}, {.5, -1, 1, 0}, {1, 0, .5, -1}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) patch.points[i][j] = {static_cast<double>(j), static_cast<double>(i), z[i][j]};
  return patch;
}

// Check case 5.
TEST(BicubicPatch, Traces) {
  EXPECT_TRACE(*make(wavy(.01, 3)), dvec3(.3, .2, -5), kZ, dvec3(.3, .2, 1.041838), dvec3(-0.500767, -0.564846, -0.655882));
  EXPECT_TRACE(*make(wavy(0, 0)), dvec3(.3, .2, -5), kZ, dvec3(.3, .2, 1.216667), dvec3(-0.523426, -0.689294, -0.500897));
  EXPECT_TRACE(*make(wavy(0, 0)), dvec3(1.5, 1.5, -5), kZ, dvec3(1.5, 1.5, .25), dvec3(-0.615457, -0.615457, -0.492366));
  EXPECT_TRACE(*make(wavy(0, 3)), dvec3(1.5, 1.5, -5), kZ, dvec3(1.5, 1.5, .0625), dvec3(-0.183942, 0.061314, -0.981023));
}

// Halved ten times the patch has a million cells, 500 bytes each; a hit is nearer to the surface than their size squared.
TEST(BicubicPatch, FineOnesAreDividedAlongTheRay) {
  const BicubicPatch patch = wavy(0, 10);
  const auto shape = make(patch);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> inner(.01, .99);
  for (int i = 0; i < 300; ++i) {
    const double u = inner(random), v = inner(random);
    const auto bernstein = [](double t) {
      return std::array<double, 4>{(1 - t) * (1 - t) * (1 - t), 3 * (1 - t) * (1 - t) * t, 3 * (1 - t) * t * t, t * t * t};
    };
    dvec3 point(0);
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < 4; ++c) point += bernstein(u)[r] * bernstein(v)[c] * patch.points[r][c];
    ShapeHit hit;
    ASSERT_TRUE(shape->nearest({{point.x, point.y, -5}, kZ}, {1e-4, 1e10}, hit));
    EXPECT_NEAR(hit.t - 5, point.z, 1e-5);
    const dvec2 uv = shape->uv(hit, point);
    EXPECT_NEAR(uv.x, v, 1e-9);
    EXPECT_NEAR(uv.y, u, 1e-9);
    // Its normal is that of a coarser patch which keeps all its facets, as far as their sizes allow.
    const auto kept = trace(*make(wavy(0, 5)), {point.x, point.y, -5}, kZ), fine = trace(*shape, {point.x, point.y, -5}, kZ);
    EXPECT_LT(test::distance(fine->normal, kept->normal), 1e-2);
  }
}

// Rays at edges and corners of cells: none passes between.
TEST(BicubicPatch, FineOnesHaveNoGaps) {
  BicubicPatch flat = wavy(0, 8);
  for (auto& row : flat.points)
    for (dvec3& point : row) point.z = 0.25 * point.x;
  const auto shape = make(flat);
  for (int i = 1; i < 256; ++i)
    for (int k = 1; k < 256; k += 5) EXPECT_TRUE(trace(*shape, {3 * k / 256.0, 3 * i / 256.0, -5}, kZ)) << i << ' ' << k;
}

// Check case 4.
TEST(BicubicPatch, UvRunsOverTheCorners) {
  BicubicPatch flat;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      flat.points[i][j] = {2 * static_cast<double>(j) / 3, -3 + 2 * static_cast<double>(i), 0};
  const auto shape = make(flat);
  ShapeHit hit;
  ASSERT_TRUE(shape->nearest({{.25, 2.25, -5}, kZ}, {1e-4, 1e10}, hit));
  const dvec2 uv = shape->uv(hit, {.25, 2.25, 0});
  EXPECT_NEAR(uv.x, .125, 1e-12);
  EXPECT_NEAR(uv.y, .875, 1e-12);
}

template <class F>
HeightField field(int width, int depth, F height, bool smooth = false) {
  auto grid = std::make_shared<HeightGrid>();
  grid->width = width;
  grid->depth = depth;
  for (int z = 0; z < depth; ++z)
    for (int x = 0; x < width; ++x)  // the image's first row is its top, the far edge of the field
      grid->heights.push_back(static_cast<std::uint16_t>(
          std::trunc(65535 * height(x / (width - 1.0), (depth - 1 - z) / (depth - 1.0)))));
  return {grid, 0, smooth};
}

// Check case 8.
TEST(HeightField, Normals) {
  const auto slope = [](double x, double y) { return x * y * .5 + .1 * x; };
  EXPECT_TRACE(*make(field(5, 5, slope)), dvec3(.3, 5, .4), kDown, dvec3(.3, 0.123743, .4),
               dvec3(-0.426330, 0.897583, 0.112198));
  EXPECT_TRACE(*make(field(5, 5, slope, true)), dvec3(.3, 5, .4), kDown, dvec3(.3, 0.123743, .4),
               dvec3(-0.390390, 0.908563, 0.148692));
}

// Check case 9.
TEST(HeightField, InsideHasNoBottom) {
  const auto shape = make(field(3, 3, [](double, double) { return .5; }));
  EXPECT_TRUE(shape->inside({.5, .4, .5}));
  EXPECT_FALSE(shape->inside({.5, .6, .5}));
  EXPECT_TRUE(shape->inside({.5, -7, .5}));
}

TEST(HeightField, PyramidFindsWhatEveryCellWould) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto hilly = [](double x, double y) { return .5 + .4 * std::sin(9 * x) * std::cos(7 * y); };
  const auto shape = make(field(38, 21, hilly));
  for (int i = 0; i < 300; ++i) {
    const dvec3 to(unit(random), .5, unit(random));
    const dvec3 from = to + dvec3(unit(random) - .5, 1, unit(random) - .5);
    ShapeHits hits;
    shape->hits({from, glm::normalize(to - from)}, {0, 1e10}, hits);
    const auto traced = trace(*shape, from, to - from);
    double nearest = 1e10;
    for (const ShapeHit& hit : hits) nearest = std::min(nearest, hit.t);
    ASSERT_EQ(traced.has_value(), !hits.empty());
    if (!traced) continue;
    EXPECT_EQ(traced->t, nearest);
    EXPECT_TRUE(shape->inside(traced->point - dvec3(0, 1e-6, 0)));
    EXPECT_FALSE(shape->inside(traced->point + dvec3(0, 1e-6, 0)));
  }
}

TEST(HeightField, WaterLevelCuts) {
  HeightField low = field(3, 3, [](double, double) { return .25; });
  low.water_level = .3;
  EXPECT_FALSE(trace(*make(low), {.3, 5, .4}, kDown));
}

JuliaFractal julia(const dvec4& c, JuliaFractal::Algebra algebra, JuliaFractal::Function function, int n, double precision) {
  JuliaFractal f;
  f.constant = c;
  f.algebra = algebra;
  f.function = function;
  f.max_iteration = n;
  f.precision = precision;
  return f;
}

using Algebra = JuliaFractal::Algebra;
using Function = JuliaFractal::Function;

#define EXPECT_JULIA(fractal, z, n) EXPECT_TRACE(*make(fractal), dvec3(.1, .2, -5), kZ, dvec3(.1, .2, z), n)

// Check case 10.
TEST(JuliaFractal, Quaternion) {
  const dvec4 c(-0.083, 0, -0.83, -0.025);
  EXPECT_JULIA(julia(c, Algebra::kQuaternion, Function::kSqr, 8, 15), -0.341340, dvec3(0.854708, 0.141788, -0.499371));
  JuliaFractal cube = julia({-.2, 0, -.3, .1}, Algebra::kQuaternion, Function::kCube, 8, 30);
  cube.slice = glm::normalize(dvec4(0, .3, .2, 1));
  cube.slice_distance = .1;
  EXPECT_JULIA(cube, -1.017328, dvec3(0.291660, 0.203303, -0.934667));
}

TEST(JuliaFractal, Hypercomplex) {
  EXPECT_JULIA(julia({-0.083, 0, -0.83, -0.025}, Algebra::kHypercomplex, Function::kSqr, 8, 15), -0.235598,
               dvec3(0.622886, 0.553172, -0.553185));
  const dvec4 c(-.1, .2, -.3, .1);
  EXPECT_JULIA(julia(c, Algebra::kHypercomplex, Function::kSqr, 6, 30), -0.871717, dvec3(0.435934, 0.636381, -0.636381));
  EXPECT_JULIA(julia(c, Algebra::kHypercomplex, Function::kCube, 6, 30), -0.871717, dvec3(0.435934, 0.636381, -0.636381));
  EXPECT_JULIA(julia(c, Algebra::kHypercomplex, Function::kExp, 6, 30), -2.527078, dvec3(0.334813, 0.666296, 0.666296));
  EXPECT_JULIA(julia(c, Algebra::kHypercomplex, Function::kReciprocal, 6, 30), -3.151396, dvec3(0.008760, 0.704734, 0.709417));
  JuliaFractal power = julia(c, Algebra::kHypercomplex, Function::kPwr, 6, 30);
  power.exponent = {1.5, .2};
  EXPECT_JULIA(power, -0.896368, dvec3(0.957286, 0.106572, -0.268786));
}

// Squares are computed as those of two complex numbers; here by the product of chapter 21 §7.3, written out.
TEST(JuliaFractal, InsideOfHypercomplexSquaresAgreesWithTheProductWrittenOut) {
  const dvec4 c(-.1, .2, -.3, .1);
  const auto shape = make(julia(c, Algebra::kHypercomplex, Function::kSqr, 6, 30));
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1.5, 1.5);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p(unit(random), unit(random), unit(random));
    dvec4 z(p, 0);
    bool stays = true;
    for (int k = 0; k < 6 && stays; ++k) {
      stays = glm::dot(z, z) <= 16;
      z = dvec4(z.x * z.x - z.y * z.y - z.z * z.z + z.w * z.w, 2 * (z.x * z.y - z.z * z.w), 2 * (z.x * z.z - z.w * z.y),
                2 * (z.x * z.w + z.y * z.z)) + c;
    }
    ASSERT_EQ(shape->inside(p), stays) << "point " << i;
    inside += stays;
  }
  EXPECT_GT(inside, 100);
}

// Orbits of quaternions are three numbers; here the products of chapter 21 §7.2, written out, in a slice that is oblique to all axes.
TEST(JuliaFractal, InsideOfQuaternionsAgreesWithTheProductWrittenOut) {
  for (const Function function : {Function::kSqr, Function::kCube}) {
    const dvec4 c(-.2, .3, -.35, .1);
    JuliaFractal fractal = julia(c, Algebra::kQuaternion, function, 6, 30);
    fractal.slice = glm::normalize(dvec4(.1, .3, .2, 1));
    fractal.slice_distance = .1;
    const auto shape = make(fractal);
    const double radius = 1 + glm::length(c);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(-1.5, 1.5);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
      const dvec3 p(unit(random), unit(random), unit(random));
      dvec4 z(p, (fractal.slice_distance - glm::dot(dvec3(fractal.slice), p)) / fractal.slice.w);
      bool stays = true;
      for (int k = 0; k < 6 && stays; ++k) {
        stays = glm::dot(z, z) <= radius * radius;
        const dvec3 v(z.y, z.z, z.w);
        const double d = glm::dot(v, v);
        const dvec4 square(z.x * z.x - d, 2 * z.x * v);
        const dvec4 cube(z.x * square.x - glm::dot(v, dvec3(square.y, square.z, square.w)), z.x * 2 * z.x * v + square.x * v);
        z = (function == Function::kSqr ? square : cube) + c;
      }
      ASSERT_EQ(shape->inside(p), stays) << "point " << i;
      inside += stays;
    }
    EXPECT_GT(inside, 100);
  }
}

// Check case 11.
TEST(JuliaFractal, Inside) {
  const auto shape = make(julia({-0.083, 0, -0.83, -0.025}, Algebra::kQuaternion, Function::kSqr, 8, 15));
  EXPECT_FALSE(shape->inside({1, 1, 0}));
  EXPECT_TRUE(shape->inside_inverted({1, 1, 0}));
}

}  // namespace
}  // namespace lute
