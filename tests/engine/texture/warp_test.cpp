#include <gtest/gtest.h>

#include "pattern_value.hpp"

namespace lute {
namespace {

// `gradient axis warp { w }` at a point.
double gradient_after(const dvec3& axis, const Warp& warp, const dvec3& point) {
  Gradient gradient;
  gradient.direction = axis;
  PatternBody body = body_of(gradient);
  body.warps.push_back(warp);
  return value_at(body, point);
}

const dvec3 kX{1, 0, 0}, kY{0, 1, 0}, kPoint{0.5, 0.2, -0.7};

// Specification chapter 50 §16 B, measured with the reference.
TEST(Warp, RepeatFlipsEveryOtherStrip) {
  RepeatWarp repeat;
  repeat.width = 2;
  repeat.flip = {-1, 1, 1};
  EXPECT_NEAR(gradient_after(kX, repeat, {2.25, 0, 0}), 0.75, 1e-11);
  EXPECT_NEAR(gradient_after(kX, repeat, {-0.25, 0, 0}), 0.25, 1e-11);
}

// `bozo warp { repeat -0.7*y offset <0.1, 0.2, 0.3> flip <1, 1, 0> }` at (12345.678, -98765.4, 555.5), measured with the reference: how
// far 141094 widths are is a number of single precision, which is off by 0.004.
TEST(Warp, RepeatMultipliesInSinglePrecision) {
  PatternBody body = body_of(Bozo());
  RepeatWarp repeat;
  repeat.axis = 1;
  repeat.width = -0.7f;
  repeat.offset = {0.1, 0.2, 0.3};
  repeat.flip = {-1, -1, 1};
  body.warps.push_back(repeat);
  EXPECT_NEAR(value_at(body, {12345.678, -98765.4, 555.5}), 0.68469349333, 1e-9);
}

TEST(Warp, BlackHoleAttracts) {
  BlackHoleWarp hole;
  hole.center = dvec3(0.5);
  hole.radius = 0.75;
  EXPECT_NEAR(gradient_after(kX, hole, {0.3, 0.5, 0.5}), 0.192444444444, 1e-11);
}

// black_hole <.5,.5,.5>, 0.75 repeat 2 turbulence 0.3, with the parse-time corrections of §5.4: the centre moves to the radius,
// the repeat widths stay above centre + radius + turbulence.
TEST(Warp, BlackHolesRepeatAtRandomPlaces) {
  BlackHoleWarp hole;
  hole.center = dvec3(0.75);
  hole.radius = 0.75;
  hole.repeat = dvec3(2);
  hole.turbulence = dvec3(0.3);
  EXPECT_NEAR(gradient_after(kX, hole, {2.8, 0.9, 0.9}), 0.717655189099, 1e-11);
}

TEST(Warp, MappingWarpsEqualTheReference) {
  EXPECT_NEAR(gradient_after(kX, SphericalWarp{}, kPoint), 0.848715771644, 1e-11);
  EXPECT_NEAR(gradient_after(kY, SphericalWarp{.dist_exp = 1}, kPoint), 0.505807093813, 1e-11);
  EXPECT_NEAR(gradient_after(kY, ToroidalWarp{}, kPoint), 0.847075801101, 1e-11);
  EXPECT_NEAR(gradient_after(kX, CylindricalWarp{.orientation = {0, 1, 0}, .dist_exp = 1}, kPoint), 0.730092912695, 1e-11);
  EXPECT_NEAR(gradient_after(kX, CubicWarp{}, kPoint), 0.785714285714, 1e-11);
}

TEST(Warp, AxesAndOriginAreDefined) {
  for (const Warp& warp : {Warp(SphericalWarp{}), Warp(ToroidalWarp{}), Warp(CylindricalWarp{})}) {
    EXPECT_FALSE(std::isnan(gradient_after(kX, warp, dvec3(0))));
    EXPECT_FALSE(std::isnan(gradient_after(kX, warp, {0, 1, 0})));
  }
}

}  // namespace
}  // namespace lute
