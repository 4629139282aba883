// Expected numbers: specification chapter 20 §12, check cases 1 and 3, unless said otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/shape/table.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST(Sphere, ScaledUnevenlyIsAnEllipsoid) {
  const auto shape = make(Sphere{}, Transform::scale({2, 1, 1}));
  EXPECT_TRACE(*shape, dvec3(1, .25, -5), kZ, dvec3(1, .25, -0.829156), dvec3(0.277350, 0.277350, -0.919866));
}

TEST(Sphere, NearHitsAreSkippedByTheMinimumDepth) {
  const auto shape = make(Sphere{});
  EXPECT_FALSE(trace(*shape, {0, 0, 0.99995}, kZ));
  EXPECT_TRACE(*shape, dvec3(0, 0, 0.9998), kZ, kZ, kZ);
}

TEST(Sphere, SurfaceIsInsideOfNeitherItselfNorItsInverse) {
  const auto shape = make(Sphere{});
  EXPECT_FALSE(shape->inside(kX));
  EXPECT_FALSE(shape->inside_inverted(kX));
}

TEST(Sphere, UniformScaleAndRotationKeepTheRadius) {
  const auto shape = make(Sphere{{1, 0, 0}, 0.5}, Transform::scale(dvec3(-2)).then(Transform::rotate({0, 30, 10})));
  const Aabb box = shape->bounds();
  EXPECT_NEAR(box.hi.x - box.lo.x, 2, 1e-12);
}

TEST(Sphere, NegativeRadiusTurnsTheNormal) {
  const auto shape = make(Sphere{dvec3(0), -1});
  EXPECT_TRACE(*shape, dvec3(0, 0, -5), kZ, dvec3(0, 0, -1), kZ);
}

TEST(Box, EdgesBelongToTheSteeperFace) {
  const auto shape = make(Box{dvec3(-1), dvec3(1)});
  EXPECT_TRACE(*shape, dvec3(-3, -3, 0), dvec3(1, 1, 0), dvec3(-1, -1, 0), -kX);
  EXPECT_TRACE(*shape, dvec3(-3, -3, 0), dvec3(1, 1.0000001, 0), dvec3(-1, -1, 0), -kY);
  EXPECT_TRACE(*shape, dvec3(-3), dvec3(1), dvec3(-1), -kX);
}

TEST(Box, FlatBoxReportsTheFaceTheRayLeavesBy) {
  const auto shape = make(Box{{-1, 0, -1}, {1, 0, 1}});
  EXPECT_TRACE(*shape, dvec3(0, 5, 0), -kY, dvec3(0), -kY);
}

// The map on the face at x = -1 of a box, at y = 0.4, z = -0.2, that is at shares 0.7 and 0.4 of its sides: (z/4, 1/3 + y/3), and mirrored
// in x the map of the face at x = 1, (3/4 - z/4, 1/3 + y/3) (chapter 20 §3). Which of them POV-Ray takes was seen in pictures of
// gradients on boxes transformed so: a scale folds into the corners, which are sorted again, until there is a rotation or matrix.
TEST(Box, OnlyScalesBehindATurnMirrorTheMap) {
  const auto u = [](const Transform& to_world) {
    const auto shape = make(Box{dvec3(-1), dvec3(1)}, to_world);
    const Ray ray{to_world.point({-5, .4, -.2}), glm::normalize(to_world.direction({1, 0, 0}))};
    ShapeHit hit;
    EXPECT_TRUE(shape->nearest(ray, {1e-4, 1e10}, hit));
    const dvec2 uv = shape->uv(hit, ray.at(hit.t));
    EXPECT_NEAR(uv.y, 1. / 3 + .7 / 3, 1e-14);
    return uv.x;
  };
  const double written = .4 / 4, sorted_again = .75 - .4 / 4, exact = 1e-14;
  const Transform flip = Transform::scale({-1, 1, 1}), turn = Transform::rotate({20, 30, 10});
  EXPECT_NEAR(u(flip), sorted_again, exact);
  EXPECT_NEAR(u(flip.then(turn)), sorted_again, exact);
  EXPECT_NEAR(u(flip.then(turn).then(flip)), sorted_again, exact);
  EXPECT_NEAR(u(flip.then(flip).then(turn)), written, exact);
  EXPECT_NEAR(u(turn.then(flip)), written, exact);
  EXPECT_NEAR(u(flip.as_matrix()), written, exact);
  EXPECT_NEAR(u(flip.then(flip.as_matrix())), sorted_again, exact);
}

TEST(Box, SurfaceIsInside) { EXPECT_TRUE(make(Box{dvec3(0), dvec3(1)})->inside({1, .5, .5})); }

TEST(Plane, IsSeenFarAway) {
  const auto shape = make(Plane{kY, -1});
  const auto traced = trace(*shape, dvec3(0), {1, -2e-7, 0});
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->point.x, 5000000, 1e-3);
  EXPECT_NEAR(traced->point.y, -1, 1e-9);
}

TEST(Plane, ScaledAndRotated) {
  const auto shape = make(Plane{kY, 1}, Transform::scale({1, 2, 1}).then(Transform::rotate({30, 0, 0})));
  EXPECT_TRACE(*shape, dvec3(0, 5, 0), -kY, dvec3(0, 2.309401, 0), dvec3(0, 0.866025, 0.5));
}

TEST(Plane, SurfaceIsInsideOfItselfAndOfItsInverse) {
  const auto shape = make(Plane{kY, 0});
  EXPECT_TRUE(shape->inside(dvec3(0)));
  EXPECT_TRUE(shape->inside_inverted(dvec3(0)));
}

TEST(Plane, BoundsItsHalfSpaceOnlyAlongAnAxis) {
  EXPECT_EQ(make(Plane{-kY, -3})->inside_bounds().lo.y, 3);
  EXPECT_TRUE(std::isinf(make(Plane{{1, 1, 0}, 3})->inside_bounds().hi.x));
}

TEST(Cylinder, RayAlongTheWallMissesWall) {
  const auto shape = make(Cylinder{-kY, kY, 1, true});
  EXPECT_FALSE(trace(*shape, {1, 5, 0}, -kY));
}

TEST(Cylinder, SurfaceIsInsideOnlyWhenOpen) {
  EXPECT_FALSE(make(Cylinder{dvec3(0), kY, 1, false})->inside({1, .5, 0}));
  EXPECT_TRUE(make(Cylinder{dvec3(0), kY, 1, true})->inside({1, .5, 0}));
}

TEST(Cylinder, CapWinsOnTheRim) {
  const auto shape = make(Cylinder{dvec3(0), kZ, 1, false});
  const auto traced = trace(*shape, {-2, 0, -1}, {1, 0, 1});
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->normal.z, -1, 1e-12);
}

TEST(Cone, TracesItsSide) {
  const auto shape = make(Cone{-kY, kY, 1, .5, false});
  EXPECT_TRACE(*shape, dvec3(.25, 0, -5), kZ, dvec3(.25, 0, -0.707107), dvec3(0.323381, 0.242536, -0.914659));
}

TEST(Cone, EndsMayBeGivenInEitherOrder) {
  const auto shape = make(Cone{kY, -kY, .5, 1, false});
  EXPECT_TRACE(*shape, dvec3(.25, 0, -5), kZ, dvec3(.25, 0, -0.707107), dvec3(0.323381, 0.242536, -0.914659));
}

TEST(Cone, RadiiOfOppositeSignMeetInAPoint) {
  const auto shape = make(Cone{-kY, kY, 1, -1, false});
  EXPECT_TRACE(*shape, dvec3(0, .5, -5), kZ, dvec3(0, .5, -.5), glm::normalize(dvec3(0, -1, -1)));
  EXPECT_TRUE(shape->inside({0, .9, 0}));
}

// Measured with POV-Ray: radii -1 and -0.5 make a cylinder of radius 0.5.
TEST(Cone, OfTwoNegativeRadiiIsTheNarrowCylinder) {
  for (const auto& [base, cap] : {std::pair{-1.0, -.5}, std::pair{-.5, -1.0}}) {
    const auto shape = make(Cone{dvec3(0), kY, base, cap});
    EXPECT_TRACE(*shape, dvec3(0, .1, -5), kZ, dvec3(0, .1, -.5), -kZ);
    EXPECT_TRACE(*shape, dvec3(0, .9, -5), kZ, dvec3(0, .9, -.5), -kZ);
  }
}

TEST(Cone, NearlyEqualRadiiAreExact) {
  const auto cone = make(Cone{dvec3(0), kY, 1, 1 - 1e-9, false});
  const auto traced = trace(*cone, {0, .5, -5}, kZ);
  ASSERT_TRUE(traced);
  EXPECT_NEAR(traced->point.z, -(1 - 5e-10), 1e-14);
}

TEST(Disc, HasAHalfSpaceBehindIt) {
  const auto shape = make(Disc{dvec3(0), kY, 1, 0});
  EXPECT_TRUE(shape->inside({5, -.1, 0}));
  EXPECT_FALSE(shape->inside({0, .1, 0}));
  EXPECT_TRUE(shape->inside_inverted({0, 0, 0}));
}

TEST(Disc, HoleAndRim) {
  const auto shape = make(Disc{{0, 1, 0}, kY, 2, .5});
  EXPECT_FALSE(trace(*shape, {.25, 5, 0}, -kY));
  EXPECT_TRUE(trace(*shape, {2, 5, 0}, -kY));
  EXPECT_FALSE(trace(*shape, {2.0001, 5, 0}, -kY));
}

TEST(Triangle, SmoothNormalIsTheBarycentricMean) {
  const SmoothTriangle description{{dvec3(0), kX, kY}, {dvec3(-1, 0, -1), dvec3(1, 0, -1), dvec3(0, 1, -1)}};
  const auto shape = make(description);
  const dvec3 mean = (glm::normalize(dvec3(-1, 0, -1)) + glm::normalize(dvec3(1, 0, -1))) * 0.4 +
                     glm::normalize(dvec3(0, 1, -1)) * 0.2;
  EXPECT_TRACE(*shape, dvec3(.4, .2, -5), kZ, dvec3(.4, .2, 0), glm::normalize(mean));
}

TEST(Triangle, SmoothNormalsOnBothSidesAreDegenerate) {
  const auto shape = make(SmoothTriangle{{dvec3(0), kX, kY}, {kZ, kZ, -kZ}});
  EXPECT_FALSE(trace(*shape, {.2, .2, -5}, kZ));
}

// Rays at random through random triangles that share an edge, aimed at the edge: none may pass between.
TEST(Triangle, SharedEdgeIsWatertight) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  int tried = 0;
  for (int i = 0; i < 20000; ++i) {
    const dvec3 a = point(), b = point(), c = point(), d = point();
    const dvec3 from = 5.0 * glm::normalize(point());
    const dvec3 at = a + (0.5 + 0.49 * unit(random)) * (b - a);
    // Seen from the origin of the ray, c and d must lie on opposite sides of the edge.
    const dvec3 edge_plane = glm::cross(a - from, b - from);
    if (glm::dot(edge_plane, c - from) * glm::dot(edge_plane, d - from) > -1e-3) continue;
    ++tried;
    const auto first = make(Triangle{{a, b, c}});
    const auto second = make(Triangle{{b, a, d}});
    EXPECT_TRUE(trace(*first, from, at - from) || trace(*second, from, at - from));
  }
  EXPECT_GT(tried, 5000);
}

// A shape and its rays, both enlarged by 10^k, have hits enlarged by 10^k: no absolute tolerance decides.
template <class Describe>
void expect_scale_free(Describe describe) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int exponent = -8; exponent <= 5; ++exponent) {
    const double s = std::pow(10.0, exponent);
    const auto small = make(describe(1.0));
    const auto scaled = make(describe(s));
    for (int i = 0; i < 500; ++i) {
      const dvec3 from = 3.0 * dvec3(unit(random), unit(random), unit(random));
      const dvec3 at(unit(random), unit(random), unit(random));
      const dvec3 direction = glm::normalize(at - from);
      ShapeHit expected, found;
      const bool hit = small->nearest({from, direction}, {0, 1e6}, expected);
      ASSERT_EQ(hit, scaled->nearest({s * from, direction}, {0, 1e12}, found)) << exponent << ' ' << i;
      if (hit) {
        EXPECT_NEAR(found.t / s, expected.t, 1e-9);
      }
    }
  }
}

// Points of random rays around the surface: what the inside test accepts stays within the range, what is clearly outside does not.
TEST(Plane, LimitsARayToWhereItIsInside) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> side(-1, 1), exponent(-16, 0);
  int removed = 0;
  for (int turn = 0; turn < 40000; ++turn) {
    const double size = std::pow(10.0, 6 * side(random));
    const auto draw = [&] { return dvec3(side(random), side(random), side(random)); };
    const bool inverted = turn % 2 != 0;
    const auto shape = make(Plane{draw(), size * side(random)});
    const Ray ray{size * draw(), glm::normalize(draw())};
    const double steep = glm::dot(ray.direction, shape->normal({}, {}));
    ShapeHit hit{100 * size * side(random), 0};
    shape->nearest(ray, {-1e300, 1e300}, hit);
    const double t = hit.t + size * side(random) * std::pow(10.0, exponent(random)) / std::max(std::abs(steep), 1e-6);
    Interval range{-1e300, 1e300};
    const bool left = shape->limit(ray, inverted, range);
    const bool kept = left && t >= range.lo && t <= range.hi;
    const bool inside = inverted ? shape->inside_inverted(ray.at(t)) : shape->inside(ray.at(t));
    if (inside) {
      EXPECT_TRUE(kept) << turn;
    } else if (std::abs(t - hit.t) * std::abs(steep) > 1e-7 * size + 1e-9 && std::abs(steep) > 1e-5) {
      EXPECT_FALSE(kept) << turn;
      ++removed;
    }
  }
  EXPECT_GT(removed, 5000);
}

// The same of shapes with bounds, by rays that pass them or meet them, from inside or far away.
void expect_limits_rays(const Shape& shape, double size, int turn, int& removed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(turn));
  std::uniform_real_distribution<double> side(-1, 1);
  const auto draw = [&] { return dvec3(side(random), side(random), side(random)); };
  const dvec3 aim = 1.2 * size * draw(), origin = (turn % 3 == 0 ? 1000 : 1.5) * size * draw();
  const Ray ray{origin, glm::normalize(aim - origin)};
  Interval range{-1e300, 1e300}, inverted = range;
  const bool left = shape.limit(ray, false, range);
  ASSERT_TRUE(shape.limit(ray, true, inverted));
  ASSERT_EQ(inverted.hi, 1e300);  // the outside has no end
  for (int i = 0; i < 20; ++i) {
    const double t = glm::length(aim - origin) + 2 * size * side(random);
    const bool kept = left && range.contains(t);
    ASSERT_TRUE(kept || !shape.inside(ray.at(t))) << turn;
    removed += !kept;
  }
  // At the surface too, where the test has its tolerance.
  ShapeHits hits;
  shape.hits(ray, {-1e300, 1e300}, hits);
  for (const ShapeHit& hit : hits) ASSERT_TRUE(left && range.contains(hit.t)) << turn;
}

TEST(Sphere, LimitsARayToWhereItIsInside) {
  int removed = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    const double size = std::pow(10.0, turn % 13 - 6);
    expect_limits_rays(*make(Sphere{size * dvec3(.2, -.1, .3), .6 * size}), size, turn, removed);
  }
  EXPECT_GT(removed, 10000);
}

TEST(Box, LimitsARayToWhereItIsInside) {
  int removed = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    const double size = std::pow(10.0, turn % 13 - 6);
    const Box box{size * dvec3(-.4, -.3, -.6), size * dvec3(.5, .4, .2)};
    expect_limits_rays(*make(box, turn % 2 == 0 ? Transform() : Transform::rotate({20, 30, 40})), size, turn, removed);
  }
  EXPECT_GT(removed, 10000);
}

TEST(Sphere, IsScaleFree) { expect_scale_free([](double s) { return Sphere{dvec3(.1 * s), .9 * s}; }); }
TEST(Box, IsScaleFree) { expect_scale_free([](double s) { return Box{dvec3(-.7 * s), dvec3(.8 * s)}; }); }
TEST(Plane, IsScaleFree) { expect_scale_free([](double s) { return Plane{{1, 2, 3}, .3 * s}; }); }
TEST(Cylinder, IsScaleFree) { expect_scale_free([](double s) { return Cylinder{dvec3(-s), dvec3(s, 0, s), .5 * s}; }); }
TEST(Cone, IsScaleFree) { expect_scale_free([](double s) { return Cone{dvec3(-s), dvec3(s, 0, s), .5 * s, .2 * s}; }); }
TEST(Disc, IsScaleFree) { expect_scale_free([](double s) { return Disc{dvec3(.1 * s), {1, 2, 3}, s, .3 * s}; }); }
TEST(Triangle, IsScaleFree) {
  expect_scale_free([](double s) { return Triangle{{dvec3(-s, -s, 0), dvec3(s, -s, .2 * s), dvec3(0, s, .1 * s)}}; });
}

TEST(Sphere, DistantOriginKeepsItsDigits) {
  const auto shape = make(Sphere{});
  ShapeHit hit;
  // Closed form: the chord at height 0.6 begins at z = -0.8; ulp(1e6) is 1.2e-10.
  ASSERT_TRUE(shape->nearest({{.6, 0, -1e6}, kZ}, {0, 1e7}, hit));
  EXPECT_NEAR(hit.t - 1e6, -0.8, 2e-10);
}

}  // namespace
}  // namespace lute
