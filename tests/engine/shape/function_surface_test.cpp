// Expected numbers: specification chapter 21 §12, check cases named at each test.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/function/function.hpp"
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
