// Expected numbers: specification chapter 21 §12, check cases named at each test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/function/function.hpp"
#include "engine/function/program.hpp"
#include "engine/shape/gradient_remark.hpp"
#include "engine/shape/isosurface.hpp"
#include "engine/shape/parametric.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

class Formula final : public Function {
 public:
  Formula(int parameters, double (*f)(const double*)) : Function(parameters, 1), f_(f) {}
  void evaluate(const double* arguments, double* results) const override { *results = f_(arguments); }

 private:
  double (*f_)(const double*);
};

Isosurface iso(double (*f)(const double*), double gradient, double accuracy = .001) {
  Isosurface s;
  s.function = std::make_shared<Formula>(3, f);
  s.max_gradient = gradient;
  s.accuracy = accuracy;
  return s;
}

double ball(const double* p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - .25; }
double height(const double* p) { return p[1]; }
double tube(const double* p) { return p[0] * p[0] + p[1] * p[1] - .25; }

// Check case 12.
TEST(Isosurface, RootsLieAtBinaryFractions) {
  EXPECT_TRACE(*make(iso(ball, 4)), dvec3(.1, .2, -5), kZ, dvec3(.1, .2, -0.446289), dvec3(0.201392, 0.401782, -0.893316));
  EXPECT_TRACE(*make(iso(ball, 4, .1)), dvec3(.1, .2, -5), kZ, dvec3(.1, .2, -0.4375), dvec3(0.309324, 0.515539, -0.799086));
  EXPECT_FALSE(trace(*make(iso(ball, .5)), {.1, .2, -5}, kZ));
  EXPECT_NEAR(trace(*make(iso(ball, 4)), {.1, .2, 0}, kZ)->point.z, 0.448086, 1e-6);
}

TEST(Isosurface, ContainerCutsAreClosedUnlessOpen) {
  Isosurface s = iso(height, 1);
  EXPECT_TRACE(*make(s), dvec3(.1, -5, .2), kY, dvec3(.1, -1, .2), -kY);
  EXPECT_TRACE(*make(s), dvec3(-5, -.5, .2), kX, dvec3(-1, -.5, .2), -kX);
  EXPECT_TRACE(*make(s), dvec3(.1, -.5, .2), kX, dvec3(1, -.5, .2), kX);
  s.open = true;
  EXPECT_TRACE(*make(s), dvec3(.1, -5, .2), kY, dvec3(.1, 0.000977, .2), kY);
  EXPECT_FALSE(trace(*make(s), {-5, -.5, .2}, kX));
}

TEST(Isosurface, Transformed) {
  const auto shape = make(iso(tube, 3), Transform::scale({1, 2, 3}).then(Transform::rotate({0, 20, 0})));
  EXPECT_TRACE(*shape, dvec3(.1, .2, -15), kZ, dvec3(.1, .2, -1.157366), dvec3(0.934796, 0.101952, -0.340238));
}

// POV-Ray's trace() and inside(): a negative radius contains the same, but the ends that the container closes are shaded by the slope of
// the function there, <0.4, 0.2, 0> + accuracy of <x, y, 0> each.
TEST(Isosurface, ContainerOfNegativeRadius) {
  Isosurface s = iso(tube, 4);
  s.container.is_sphere = true;
  s.container.radius = .9;
  EXPECT_TRACE(*make(s), dvec3(.2, .1, -5), kZ, dvec3(.2, .1, -0.8717798), dvec3(0.2222222, 0.1111111, -0.9686442));
  s.container.radius = -.9;
  const auto shape = make(s);
  EXPECT_TRACE(*shape, dvec3(.2, .1, -5), kZ, dvec3(.2, .1, -0.8717798), dvec3(0.8939809, 0.4481051, 0));
  EXPECT_TRACE(*shape, dvec3(-5, .1, .2), kX, dvec3(-0.4895248, .1, .2), dvec3(-0.9795288, 0.2013040, 0));
  EXPECT_TRUE(shape->inside({0, 0, .5}));
  EXPECT_FALSE(shape->inside({0, 0, .95}));
  EXPECT_NEAR(shape->bounds().hi.z, .9, 1e-15);
}

// x² + y² + z² - 0.25 as a program, whose slope is known: on the surface it is 1, at the corners of the container 2 √3.
Isosurface known_ball(double max_gradient) {
  ExpressionBuilder e;
  const auto square = [&](int axis) { return e.binary(BinaryOp::kMultiply, e.parameter(axis), e.parameter(axis)); };
  const auto sum = e.binary(BinaryOp::kAdd, e.binary(BinaryOp::kAdd, square(0), square(1)), square(2));
  Isosurface s;
  s.function = e.finish(e.binary(BinaryOp::kSubtract, sum, e.constant(0.25)), 3);
  s.max_gradient = max_gradient;
  return s;
}

TEST(Isosurface, NeedsNoMaxGradientWhereTheSlopeOfTheFunctionIsKnown) {
  const auto enough = make(known_ball(4)), too_small = make(known_ball(0.01));
  int hits = 0;
  for (int i = -20; i <= 20; ++i)
    for (int k = -20; k <= 20; ++k) {
      const dvec3 from(0.031 * i, 0.031 * k, -5);
      const auto expected = trace(*enough, from, kZ), found = trace(*too_small, from, kZ);
      ASSERT_EQ(found.has_value(), expected.has_value()) << i << ' ' << k;
      if (!expected) continue;
      ++hits;
      EXPECT_EQ(found->t, expected->t);
    }
  EXPECT_GT(hits, 700);  // π 0.25 of 1.27² are 49 % of 1681 rays
}

// What is proven grows with the rays that have asked; the hits do not change.
TEST(Isosurface, HitsDoNotDependOnEarlierRays) {
  const auto fresh = make(known_ball(0.3)), old = make(known_ball(0.3));
  for (int i = 0; i < 3000; ++i) trace(*old, {0.6 * std::sin(i), 0.6 * std::cos(1.7 * i), -5}, kZ);
  for (int i = -20; i <= 20; ++i) {
    const dvec3 from(0.031 * i, 0.02 * i, -5);
    const auto expected = trace(*fresh, from, kZ), found = trace(*old, from, kZ);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (expected) { EXPECT_EQ(found->t, expected->t); }
  }
}

// A shadow ray does not look for the depth of a hit that lies within its range: it must find one where the other queries do.
TEST(Isosurface, AnyHitIsFoundWhereThereAreHits) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int found = 0, missed = 0;
  for (const double max_gradient : {4.0, 0.3})
    for (const bool open : {false, true}) {
      Isosurface s = known_ball(max_gradient);
      s.open = open;
      s.max_trace = open ? 1 : 10;
      if (open) s.container.hi = dvec3(0.4);  // cuts into the ball
      const auto shape = make(s);
      for (int i = 0; i < 3000; ++i) {
        const dvec3 from(unit(random), unit(random), unit(random)), direction(unit(random), unit(random), unit(random));
        const Ray ray{1.2 * from, glm::normalize(0.5 * direction - from)};
        const double lo = 0.8 * std::abs(unit(random));
        const Interval range{lo, lo + 1.5 * std::abs(unit(random))};
        ShapeHit hit;
        const bool nearest = shape->nearest(ray, range, hit);
        ASSERT_EQ(shape->any(ray, range), nearest) << "ray " << i << ", max_gradient " << max_gradient << ", open " << open;
        ++(nearest ? found : missed);
      }
    }
  EXPECT_GT(found, 2000);
  EXPECT_GT(missed, 3000);
}

// The reference says so of grad = 2.225 and 1.5, and of 3.078 and 10, for rays that see the whole ball.
TEST(Isosurface, RemarksOnAMaxGradientFarFromTheSlopesThatRaysFind) {
  const auto remark = [](const Isosurface& s) {
    const auto shape = make(s);
    for (int i = -5; i <= 5; ++i) trace(*shape, {0.1 * i, 0.1, -5}, kZ);
    return gradient_remark(*shape).text();
  };
  EXPECT_EQ(remark(known_ball(2)), "");
  EXPECT_THAT(remark(known_ball(0.5)), testing::HasSubstr("max_gradient of the isosurface was set to 0.500; proofs stand in"));
  EXPECT_THAT(remark(iso(ball, 0.8)), testing::HasSubstr("may contain holes"));
  EXPECT_THAT(remark(known_ball(10)), testing::HasSubstr("a smaller one takes less time"));
  EXPECT_EQ(gradient_remark(*make(known_ball(0.5))).text(), "");  // no ray has asked
}

// Radii of 1e308, infinity and not a number have ended the search with the stack.
TEST(Isosurface, ContainerWithoutFiniteDepthsShowsNothing) {
  for (const double radius : {1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Isosurface s = iso(ball, 4);
    s.container.is_sphere = true;
    s.container.radius = radius;
    EXPECT_FALSE(trace(*make(s), {.1, .2, -5}, kZ));
    s.container.is_sphere = false;
    s.container.lo = dvec3(-1, -1, radius);
    EXPECT_FALSE(trace(*make(s), {.1, .2, -5}, kZ));
  }
}

Parametric surface(double (*x)(const double*), double (*y)(const double*), double (*z)(const double*), double gradient) {
  Parametric p;
  p.functions = {std::make_shared<Formula>(2, x), std::make_shared<Formula>(2, y), std::make_shared<Formula>(2, z)};
  p.lo = dvec2(-1);
  p.hi = dvec2(1);
  p.max_gradient = gradient;
  return p;
}

double u_of(const double* a) { return a[0]; }
double v_of(const double* a) { return a[1]; }

// Check case 14.
TEST(Parametric, Traces) {
  Parametric flat = surface(u_of, v_of, [](const double*) { return 0.0; }, 1.1);
  flat.accuracy = .01;
  flat.container.lo = dvec3(-1.1);
  flat.container.hi = dvec3(1.1);
  EXPECT_TRACE(*make(flat), dvec3(.2, .3, -5), kZ, dvec3(.2, .3, -0.018594), kZ);
  const Parametric saddle = surface(u_of, v_of, [](const double* a) { return a[0] * a[1]; }, 1.5);
  EXPECT_TRACE(*make(saddle), dvec3(.2, .3, -5), kZ, dvec3(.2, .3, 0.057506), dvec3(-0.282086, -0.187445, 0.940900));
  Parametric sphere = surface([](const double* a) { return std::sin(a[0]) * std::cos(a[1]); },
                              [](const double* a) { return std::sin(a[0]) * std::sin(a[1]); },
                              [](const double* a) { return std::cos(a[0]); }, 1.5);
  sphere.lo = dvec2(0);
  sphere.hi = dvec2(kPi, 2 * kPi);
  EXPECT_TRACE(*make(sphere), dvec3(.2, .3, -5), kZ, dvec3(.2, .3, -0.934729), dvec3(0.200793, 0.299836, -0.932620));
}

}  // namespace
}  // namespace lute
