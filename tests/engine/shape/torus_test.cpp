#include "engine/shape/torus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kY(0, 1, 0), kZ(0, 0, 1);

// Specification chapter 20 §12, check case 1.
TEST(Torus, TracesTheTube) {
  const auto shape = make(Torus{1, .25});
  EXPECT_TRACE(*shape, dvec3(1.1, 5, 0), -kY, dvec3(1.1, 0.229129, 0), dvec3(0.4, 0.916515, 0));
}

// Check case 3.
TEST(Torus, SurfaceIsInside) { EXPECT_TRUE(make(Torus{1, .25})->inside({1.25, 0, 0})); }

TEST(Torus, RayThroughTheMiddleHasFourHits) {
  ShapeHits hits;
  make(Torus{1, .25})->hits({{-5, 0, 0}, {1, 0, 0}}, {0, 1e10}, hits);
  ASSERT_EQ(hits.size(), 4u);
  const double expected[] = {3.75, 4.25, 5.75, 6.25};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(hits[i].t, expected[i], 1e-13);
}

TEST(Torus, GrazingRayKeepsDoubleRoot) {
  const auto shape = make(Torus{1, .25});
  const auto traced = trace(*shape, {1.25, 5, 0}, -kY);
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->point.y, 0, 1e-7);
  // Just inside, just outside.
  EXPECT_TRUE(trace(*shape, {1.25 - 1e-12, 5, 0}, -kY));
  EXPECT_FALSE(trace(*shape, {1.25 + 1e-12, 5, 0}, -kY));
}

TEST(Torus, ThinTubeKeepsItsDigits) {
  const double r = 1e-6;
  const auto shape = make(Torus{1, r});
  // Straight down onto the tube, at 0.6 of its radius beside its middle: y = 0.8 r.
  const auto traced = trace(*shape, {1 + .6 * r, 2, 0}, -kY);
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->point.y / r, .8, 1e-8);
  EXPECT_NEAR(traced->normal.y, .8, 1e-8);
}

TEST(Torus, DistantOriginKeepsItsDigits) {
  const auto shape = make(Torus{1, .25});
  ShapeHit hit;
  ASSERT_TRUE(shape->nearest({{1.1, 1e6, 0}, -kY}, {1e-4, 1e10}, hit));
  EXPECT_NEAR(1e6 - hit.t, 0.22912878474779, 3e-10);
}

TEST(Torus, RandomHitsLieOnTheSurfaceAtEveryScale) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int exponent = -7; exponent <= 7; ++exponent) {
    const double s = std::pow(10.0, exponent);
    const auto shape = make(Torus{s, .3 * s}, Transform::rotate({20, 30, 40}));
    const Transform back = Transform::rotate({20, 30, 40}).inverse();
    int found = 0;
    for (int i = 0; i < 300; ++i) {
      const dvec3 from = s * dvec3(3 * unit(random), 3 * unit(random), -4);
      const dvec3 direction = glm::normalize(s * dvec3(unit(random), unit(random), unit(random)) - from);
      ShapeHits hits;
      shape->hits({from, direction}, {0, 1e12}, hits);
      EXPECT_EQ(hits.size() % 2, shape->inside(from) ? 1u : 0u);
      for (const ShapeHit& hit : hits) {
        const dvec3 p = back.point(from + hit.t * direction);
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.z) / s - 1, p.y / s), .3, 1e-12);
        ++found;
      }
    }
    EXPECT_GT(found, 100);
  }
}

TEST(Torus, ZeroOrNegativeRadiusDrawsNothing) {
  EXPECT_FALSE(trace(*make(Torus{1, 0}), {1, 5, 0}, -kY));
  EXPECT_FALSE(trace(*make(Torus{1, -.25}), {1.1, 5, 0}, -kY));
}

TEST(Torus, BoundsAreTight) {
  const Aabb box = make(Torus{1, .25}, Transform::rotate({90, 0, 0}))->bounds();
  EXPECT_NEAR(box.hi.y, 1.25, 1e-12);
  EXPECT_NEAR(box.hi.z, .25, 1e-12);
}

}  // namespace
}  // namespace lute
