// Small shaded pictures: specification chapter 20 §12, check cases 4 to 8. A white diffuse object lit along the view: a pixel's value is
// the cosine of the angle at which it is seen, times 255.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/shape/blob.hpp"
#include "engine/shape/box.hpp"
#include "engine/shape/sphere.hpp"
#include "engine/shape/sphere_sweep.hpp"
#include "engine/shape/torus.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

// One row of the 8 x 8 picture of the view <-2, -2> to <2, 2> from z = -10.
std::string row(const Shape& shape, int y) {
  std::string values;
  for (int x = 0; x < 8; ++x) {
    const auto traced = trace(shape, {-2 + (x + .5) * .5, 2 - (y + .5) * .5, -10}, {0, 0, 1});
    const int value = traced ? static_cast<int>(std::lround(255 * std::abs(traced->normal.z))) : 0;
    values += (x ? " " : "") + std::to_string(value);
  }
  return values;
}

TEST(ShadedPicture, Sphere) {
  const auto shape = make(Sphere{dvec3(0), 1.5});
  EXPECT_EQ(row(*shape, 1), "0 0 60 134 134 60 0 0");
  EXPECT_EQ(row(*shape, 2), "0 60 180 217 217 180 60 0");
}

TEST(ShadedPicture, Torus) {
  const auto shape = make(Torus{1, .4}, Transform::rotate({60, 0, 30}));
  EXPECT_EQ(row(*shape, 1), "0 0 0 33 114 0 0 0");
  EXPECT_EQ(row(*shape, 2), "0 0 224 249 227 226 0 0");
  EXPECT_EQ(row(*shape, 3), "0 130 233 0 0 182 158 0");
}

TEST(ShadedPicture, Box) {
  const auto shape = make(Box{dvec3(-1), dvec3(1)}, Transform::rotate({30, 40, 10}));
  EXPECT_EQ(row(*shape, 4), "0 169 169 169 164 164 164 0");
  EXPECT_EQ(row(*shape, 5), "0 98 98 98 98 164 164 0");
}

TEST(ShadedPicture, SphereSweepWithItsArtefacts) {
  SphereSweep sweep{SphereSweep::Spline::kCubic,
                    {{{-2, -1, 0}, .6}, {{-1, 1, 0}, .8}, {{0, -1, 0}, .5}, {{1, 1, 0}, .8}, {{2, -1, 0}, .6}}, 1e-6};
  const auto cubic = make(sweep);
  EXPECT_EQ(row(*cubic, 0), "0 39 44 0 0 44 39 0");
  EXPECT_EQ(row(*cubic, 1), "39 229 232 107 107 232 229 39");
  EXPECT_EQ(row(*cubic, 2), "39 229 252 190 190 252 229 39");
  EXPECT_EQ(row(*cubic, 3), "0 124 246 223 223 246 124 0");
  EXPECT_EQ(row(*cubic, 4), "0 0 218 244 244 218 0 0");
  // The reference has 180 for the second 253: a root that its solver loses on one side of a symmetrical sweep.
  EXPECT_EQ(row(*cubic, 5), "0 0 130 253 253 130 0 0");
  EXPECT_EQ(row(*cubic, 6), "0 0 0 192 192 0 0 0");
  sweep.spline = SphereSweep::Spline::kBSpline;
  const auto b_spline = make(sweep);
  EXPECT_EQ(row(*b_spline, 2), "0 187 194 0 0 194 187 0");
  EXPECT_EQ(row(*b_spline, 3), "0 237 254 213 213 254 237 0");
  EXPECT_EQ(row(*b_spline, 4), "0 118 213 254 254 213 118 0");
  EXPECT_EQ(row(*b_spline, 5), "0 0 0 165 165 0 0 0");
}

TEST(ShadedPicture, Blob) {
  Blob blob;
  blob.threshold = .4;
  BlobComponent rod;
  rod.kind = BlobComponent::Kind::kCylinder;
  rod.center = {-1, -.7, 0};
  rod.apex = {1, .5, 0};
  rod.radius = .8;
  BlobComponent dent;
  dent.center = {0, .9, 0};
  dent.radius = .9;
  dent.strength = -.6;
  blob.components = {rod, dent};
  const auto shape = make(blob);
  EXPECT_EQ(row(*shape, 2), "0 0 0 0 0 153 175 0");
  EXPECT_EQ(row(*shape, 3), "0 0 0 28 215 251 175 0");
  EXPECT_EQ(row(*shape, 4), "0 0 216 255 216 0 0 0");
  EXPECT_EQ(row(*shape, 5), "0 217 239 119 0 0 0 0");
}

}  // namespace
}  // namespace lute
