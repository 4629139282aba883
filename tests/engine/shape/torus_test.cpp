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

// POV-Ray's trace() and inside() of tori with negative radii. Of these rays it shows what they meet of the tube of radius |R| if they pass
// the ring of the radii as written: here |y| <= 0.3, √(x² + z²) <= 0.7, or 1.3 by the end faces alone where r is negative too.
TEST(Torus, NegativeMajorRadiusIsSeenThroughItsWindow) {
  const auto thin = make(Torus{-1, .3});
  EXPECT_TRACE(*thin, dvec3(.2, .1, -5), kZ, dvec3(.2, .1, -1.2671564), dvec3(0.1557544, 0.0437631, -0.9868259));
  EXPECT_TRACE(*thin, dvec3(0), dvec3(1, 0, 0), dvec3(.7, 0, 0), dvec3(1, 0, 0));
  EXPECT_FALSE(trace(*thin, {.9, .1, -5}, kZ));
  EXPECT_FALSE(trace(*thin, {1, 5, 0}, -kY));
  EXPECT_FALSE(thin->inside({1, 0, 0}));
  const auto both = make(Torus{-1, -.3});
  EXPECT_FALSE(trace(*both, {.2, .1, -5}, kZ));
  EXPECT_TRACE(*both, dvec3(1.1, 3, 0), -kY, dvec3(1.1, 0.2828427, 0), dvec3(0.9910513, 0.1334817, 0));
  EXPECT_TRACE(*both, dvec3(0, 5, 0), dvec3(.23, -1, 0), dvec3(1.0837428, 0.2880749, 0), dvec3(0.9905785, 0.1369463, 0));
  const auto stout = make(Torus{-.3, 1});
  EXPECT_TRACE(*stout, dvec3(.6, .1, -5), kZ, dvec3(.6, .1, -1.1476029), dvec3(0.4624170, 0.0625736, -0.8844518));
  EXPECT_TRACE(*stout, dvec3(.3, 5, .2), -kY, dvec3(.3, 0.9981649, .2), dvec3(0.4591834, 0.8339303, 0.3061222));
  EXPECT_FALSE(trace(*stout, {.9, .1, -5}, kZ));
  EXPECT_TRUE(stout->inside({.1, 0, 0}));
  EXPECT_FALSE(stout->inside({.75, 0, 0}));
  EXPECT_FALSE(trace(*make(Torus{1, -.3}), {1, 5, 0}, -kY));
}

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

// POV-Ray's picture of torus{.3, -.8} is empty, its inside() that of a positive radius.
TEST(Torus, OfNegativeMinorRadiusHasAnInsideAlone) {
  const auto shape = test::make(Torus{.3, -.8, false});
  EXPECT_FALSE(test::trace(*shape, {.2, 3, .1}, {0, -1, 0}));
  EXPECT_TRUE(shape->inside({1, 0, 0}));
  EXPECT_FALSE(shape->inside({1.2, 0, 0}));
}

}  // namespace
}  // namespace lute
