// Expected numbers: specification chapter 20 §12, check cases 1 and 3, unless said otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <glm/common.hpp>

#include "engine/shape/blob.hpp"
#include "engine/shape/poly.hpp"
#include "engine/shape/quadric.hpp"
#include "engine/shape/superellipsoid.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kX(1, 0, 0), kZ(0, 0, 1);

BlobComponent ball(const dvec3& center, double radius, double strength) {
  BlobComponent c;
  c.center = center;
  c.radius = radius;
  c.strength = strength;
  return c;
}

BlobComponent rod(const dvec3& base, const dvec3& apex, double radius, double strength) {
  BlobComponent c = ball(base, radius, strength);
  c.kind = BlobComponent::Kind::kCylinder;
  c.apex = apex;
  return c;
}

TEST(Superellipsoid, Traces) {
  EXPECT_TRACE(*make(Superellipsoid{.5, .5}), dvec3(.3, .2, -5), kZ, dvec3(.3, .2, -0.997566),
               dvec3(0.027187, 0.008055, -0.999598));
  EXPECT_TRACE(*make(Superellipsoid{.25, 1}), dvec3(.3, .2, -5), kZ, dvec3(.3, .2, -0.953486),
               dvec3(0.292329, 0.017109, -0.956165));
}

TEST(Superellipsoid, WithExponentsOneIsASphere) {
  const auto shape = make(Superellipsoid{1, 1});
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const dvec3 from(3 * unit(random), 3 * unit(random), -3);
    const dvec3 d = glm::normalize(dvec3(unit(random), unit(random), unit(random)) - from);
    const double b = -glm::dot(from, d);
    const dvec3 apart = from + b * d;
    const double h = 1 - glm::dot(apart, apart);
    if (std::abs(h) < 1e-9) continue;
    const auto traced = trace(*shape, from, d);
    ASSERT_EQ(traced.has_value(), h > 0) << i << ' ' << h;
    if (traced) {
      EXPECT_NEAR(traced->t, b - std::sqrt(h), 1e-9 / std::sqrt(h));
    }
  }
}

TEST(Blob, TracesBalls) {
  const auto shape = make(Blob{.6, {ball({-.75, 0, 0}, 1, 1), ball({.75, 0, 0}, 1, 1)}});
  EXPECT_TRACE(*shape, dvec3(-.75, 0, -5), kZ, dvec3(-.75, 0, -0.474767), dvec3(0, 0, -1));
}

TEST(Blob, TracesCylinders) {
  const auto shape = make(Blob{.6, {rod(-kX, kX, 1, 1)}});
  EXPECT_TRACE(*shape, dvec3(-5, .1, 0), kX, dvec3(-1.464116, .1, 0), dvec3(-0.977566, 0.210630, 0));
}

// Check case 9.
TEST(Blob, HitsNearerThanAHundredthAreSkipped) {
  const auto shape = make(Blob{.6, {ball(dvec3(0), 1, 1)}});
  EXPECT_GT(trace(*shape, {0, 0, -0.474767 - .009}, kZ)->point.z, 0);
  EXPECT_LT(trace(*shape, {0, 0, -0.474767 - .011}, kZ)->point.z, 0);
}

// Many components are found through a tree; a blob of few, all others out of reach, must look the same.
TEST(Blob, ManyComponentsAgreeWithFew) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::vector<BlobComponent> few{ball({-.75, 0, 0}, 1, 1), rod({0, -.5, 0}, {.5, .5, .2}, .8, 1), ball({.4, .3, -.5}, .5, -.4)};
  Blob many{.4, few};
  for (int i = 0; i < 100; ++i) many.components.push_back(ball({10 + unit(random), unit(random), unit(random)}, .5, 1));
  const auto small = make(Blob{.4, few});
  const auto large = make(many);
  for (int i = 0; i < 500; ++i) {
    const dvec3 from(2 * unit(random), 2 * unit(random), -5);
    const auto a = trace(*small, from, kZ);
    const auto b = trace(*large, from, kZ);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_NEAR(a->t, b->t, 1e-9);
    EXPECT_LT(test::distance(a->normal, b->normal), 1e-6);
    EXPECT_EQ(small->inside(a->point + .01 * kZ), large->inside(a->point + .01 * kZ));
  }
}

TEST(Blob, TransformedComponentIsEvaluatedInItsOwnSpace) {
  BlobComponent c = ball(dvec3(0), 1, 1);
  c.transform = Transform::scale({1, 1, 2}).then(Transform::translate({1, 0, 0}));
  const auto shape = make(Blob{.6, {c}});
  EXPECT_TRACE(*shape, dvec3(1, 0, -5), kZ, dvec3(1, 0, -2 * 0.474767), dvec3(0, 0, -1));
}

TEST(Blob, TexturesAreWeightedByDensity) {
  Blob blob{.6, {ball({-.5, 0, 0}, 1, 1), ball({.5, 0, 0}, 1, 1)}};
  blob.components[0].texture = std::shared_ptr<const Texture>(std::shared_ptr<void>(), reinterpret_cast<const Texture*>(&blob));
  std::vector<TextureWeight> weights;
  make(blob)->textures({}, {0, .1, 0}, weights);
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_FLOAT_EQ(weights[0].weight, .5f);
}

Poly sphere_poly() { return {2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}}; }

TEST(Poly, SurfaceShellIsInside) {
  const auto shape = make(sphere_poly());
  EXPECT_TRUE(shape->inside({1.00004, 0, 0}));
  EXPECT_FALSE(shape->inside({1.00006, 0, 0}));
}

TEST(Poly, QuadraticIsTheSphere) {
  EXPECT_TRACE(*make(sphere_poly()), dvec3(.6, 0, -5), kZ, dvec3(.6, 0, -.8), dvec3(.6, 0, -.8));
}

// The reference loses the triple root without sturm (check case 16); it is seen here.
TEST(Poly, TripleRootIsSeen) {
  Poly cubic{3, std::vector<double>(Poly::term_count(3))};
  cubic.coefficients[Poly::term_index(3, 0, 0, 3)] = 1;
  EXPECT_TRUE(trace(*make(cubic), {.2, .1, -5}, kZ));
}

// Chapter 20 §5.8: of order 3 and more what is left of a plane is not seen, of order 2 it is.
TEST(Poly, PlaneIsSeenOfOrderTwoOnly) {
  for (const int order : {2, 3, 4}) {
    Poly poly;
    poly.order = order;
    poly.coefficients.assign(static_cast<std::size_t>((order + 1) * (order + 2) * (order + 3) / 6), 0);
    poly.coefficients[poly.coefficients.size() - 2] = 1;  // z
    poly.coefficients.back() = -1;
    EXPECT_EQ(trace(*make(poly), {.1, .2, -5}, kZ).has_value(), order == 2) << order;
  }
}

TEST(Poly, TermsAreInTheOrderOfTheManual) {
  EXPECT_EQ(Poly::term_index(2, 2, 0, 0), 0u);
  EXPECT_EQ(Poly::term_index(2, 1, 0, 1), 2u);
  EXPECT_EQ(Poly::term_index(2, 0, 0, 0), 9u);
  EXPECT_EQ(Poly::term_index(4, 0, 0, 4), 30u);
}

TEST(Poly, QuarticTorusAgreesWithTheTorus) {
  // (x² + y² + z² + R² - r²)² = 4 R² (x² + z²), R = 1, r = 0.25.
  Poly torus{4, std::vector<double>(35)};
  const double k = 1 - .0625;
  const auto set = [&](int i, int j, int l, double value) { torus.coefficients[Poly::term_index(4, i, j, l)] = value; };
  set(4, 0, 0, 1), set(0, 4, 0, 1), set(0, 0, 4, 1);
  set(2, 2, 0, 2), set(2, 0, 2, 2), set(0, 2, 2, 2);
  set(2, 0, 0, 2 * k - 4), set(0, 2, 0, 2 * k), set(0, 0, 2, 2 * k - 4), set(0, 0, 0, k * k);
  EXPECT_TRACE(*make(torus), dvec3(1.1, 5, 0), dvec3(0, -1, 0), dvec3(1.1, 0.229129, 0), dvec3(0.4, 0.916515, 0));
}

TEST(Quadric, ParaboloidAndItsInside) {
  const auto shape = make(Quadric{{1, 0, 1}, {0, 0, 0}, {0, -1, 0}, 0});
  EXPECT_TRACE(*shape, dvec3(.5, 5, 0), dvec3(0, -1, 0), dvec3(.5, .25, 0), glm::normalize(dvec3(1, -1, 0)));
  EXPECT_TRUE(shape->inside({.5, .25, 0}));
  EXPECT_FALSE(shape->bounds().is_finite());
}

// A cylinder's matrix is singular; no rotation may make a small ellipsoid of it by rounding.
TEST(Quadric, RotatedCylinderStaysUnbounded) {
  for (int degrees = -180; degrees <= 180; ++degrees) {
    const Transform turn = Transform::rotate({degrees * 0.37, -75.0 + degrees, degrees * 0.11}).then(Transform::translate({0, -3, 25}));
    const auto cylinder = make(Quadric{{0, 1, 1}, {0, 0, 0}, {0, 0, 0}, -1}, turn);
    EXPECT_EQ(cylinder->bounds().volume(), Aabb::infinite().volume()) << degrees;
    EXPECT_EQ(cylinder->bounds().lo.x, Aabb::infinite().lo.x) << degrees;
  }
  // The same with the rotation written into the coefficients: (y cos a + x sin a)² + z² = 1.
  for (int degrees = 1; degrees < 90; ++degrees) {
    const double c = std::cos(degrees * 0.0174), s = std::sin(degrees * 0.0174);
    const auto cylinder = make(Quadric{{s * s, c * c, 1}, {2 * s * c, 0, 0}, {0, 0, 0}, -1});
    EXPECT_EQ(cylinder->bounds().lo.x, Aabb::infinite().lo.x) << degrees;
  }
}

// Whatever the quadric and however it is turned, what lies inside it and in the region lies in the box.
TEST(Quadric, BoxWithinARegionLosesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  const double inf = std::numeric_limits<double>::infinity();
  int inside = 0, narrowed = 0;
  for (int i = 0; i < 400; ++i) {
    const Quadric description{any(), i % 2 == 0 ? dvec3(0) : any(), i % 3 == 0 ? dvec3(0) : any(), unit(random)};
    const auto quadric = make(description, Transform::rotate(90.0 * glm::floor(2.0 * any())).then(Transform::translate(any())));
    Aabb region = Aabb::infinite();
    for (int axis = 0; axis < 3; ++axis) {
      if (unit(random) < 0) continue;
      region.lo[axis] = -1 + unit(random);
      region.hi[axis] = unit(random) < 0 ? inf : 1 + unit(random);
    }
    const Aabb box = quadric->inside_within(region, false);
    narrowed += box.lo != region.lo || box.hi != region.hi;
    for (int k = 0; k < 200; ++k) {
      const dvec3 p = 4.0 * any();
      if (!region.contains(p) || !quadric->inside(p)) continue;
      ++inside;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p[axis], box.lo[axis] - 1e-9) << i;
        EXPECT_LE(p[axis], box.hi[axis] + 1e-9) << i;
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(narrowed, 50);
}

TEST(Quadric, TransformedEllipsoidHasTightBounds) {
  const auto shape = make(Quadric{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, -1},
                          Transform::scale({1, 2, 3}).then(Transform::rotate({0, 90, 0})).then(Transform::translate({5, 0, 0})));
  const Aabb box = shape->bounds();
  EXPECT_NEAR(box.lo.x, 2, 1e-9);
  EXPECT_NEAR(box.hi.y, 2, 1e-9);
  EXPECT_NEAR(box.hi.z, 1, 1e-9);
}

}  // namespace
}  // namespace lute
