// The four intersections of the lecture in numbers that can be checked by hand: plane in Hesse's form, triangle by barycentric
// coordinates, box by slabs, sphere by its quadratic; each with the ways to miss it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "engine/shape/table.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;

// The depth of the nearest hit along a direction that is not normalised, in its units.
template <class Description>
std::optional<double> depth(const Description& description, const dvec3& from, const dvec3& direction) {
  const auto shape = make(description);
  const double length = glm::length(direction);
  ShapeHit hit;
  if (!shape->nearest({from, direction / length}, {1e-9, std::numeric_limits<double>::infinity()}, hit)) return std::nullopt;
  return hit.t / length;
}

template <class Description>
void expect_depth(const Description& description, const dvec3& from, const dvec3& direction, double expected) {
  const std::optional<double> found = depth(description, from, direction);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, expected, 4e-15 * (1 + expected));
}

const Plane kPlane{{0, 0.6, 0.8}, 2};  // 0.6 y + 0.8 z = 2

TEST(RayPlane, HesseForm) {
  expect_depth(kPlane, {7, 0, 0}, {0, 0, 1}, 2.5);           // 0.8 t = 2
  expect_depth(kPlane, {0, 5, 0}, {0, -1, 0}, 5.0 / 3);      // 3 - 0.6 t = 2
  expect_depth(kPlane, {0, 1, 1}, {0, 1, 1}, 3.0 / 7);       // 1.4 + 1.4 t = 2
}
TEST(RayPlane, ParallelAndBehind) {
  EXPECT_FALSE(depth(kPlane, {0, 0, 0}, {0, 0.8, -0.6}));
  EXPECT_FALSE(depth(kPlane, {0, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(depth(kPlane, {0, 0, 0}, {0, 0, -1}));
}

const Triangle kTriangle{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};  // x + y + z = 1

TEST(RayTriangle, InsideByBarycentricCoordinates) {
  expect_depth(kTriangle, {0, 0, 0}, {1, 1, 1}, 1.0 / 3);         // the middle
  expect_depth(kTriangle, {0, 0, 0}, {0.5, 0.25, 0.25}, 1);       // weights 1/2, 1/4, 1/4
  expect_depth(kTriangle, {2, 2, 2}, {-1, -1, -1}, 5.0 / 3);      // from the other side
}
TEST(RayTriangle, OutsideEachEdge) {
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 to(0.6, 0.6, 0.6);
    to[axis] = -0.2;  // on the plane, its weight negative
    EXPECT_FALSE(depth(kTriangle, {0, 0, 0}, to)) << axis;
  }
  EXPECT_FALSE(depth(kTriangle, {0, 0, 0}, {-1, -1, -1}));  // behind
  EXPECT_FALSE(depth(kTriangle, {0, 0, 0}, {1, -1, 0}));    // parallel
}

const Box kBox{{-1, -2, -3}, {1, 2, 3}};

TEST(RayBox, EntersByTheLastSlab) {
  expect_depth(kBox, {-5, 0, 0}, {1, 0, 0}, 4);
  expect_depth(kBox, {-4, -4, 0}, {1, 1, 0}, 3);       // x from 3 to 5, y from 2 to 6
  expect_depth(kBox, {-2, -4, -9}, {1, 1, 2}, 3);      // x from 1, y from 2, z from 3
  expect_depth(kBox, {0, 0, 0}, {0, 2, 0}, 1);         // from inside: where it leaves
}
TEST(RayBox, Misses) {
  expect_depth(kBox, {-4, -7, 0}, {1, 1, 0}, 5);          // leaves x as it enters y: the edge is still part of the box
  EXPECT_FALSE(depth(kBox, {-4, -7.001, 0}, {1, 1, 0}));  // leaves x before it enters y
  EXPECT_FALSE(depth(kBox, {5, 0, 0}, {1, 0, 0}));        // behind
  EXPECT_FALSE(depth(kBox, {-5, 2.5, 0}, {1, 0, 0}));     // parallel to a slab and outside of it
  EXPECT_FALSE(depth(kBox, {-5, 2.5, 0}, {1, -0.0, 0}));  // the same with the other zero
}

const Sphere kSphere{dvec3(1, 2, 3), 5};

TEST(RaySphere, QuadraticHasTwoRoots) {
  expect_depth(kSphere, {1, 2, -7}, {0, 0, 1}, 5);
  expect_depth(kSphere, {4, 2, -7}, {0, 0, 1}, 6);      // 3 beside the middle: 10 - 4
  expect_depth(kSphere, {4, 2, 3}, {0, 0, 2}, 2);       // from inside: 4 in steps of 2
}
TEST(RaySphere, TangentGrazingAndBehind) {
  EXPECT_FALSE(depth(kSphere, {6, 2, -7}, {0, 0, 1}));  // touches: a chord of no length is no hit
  EXPECT_FALSE(depth(kSphere, {6.0000001, 2, -7}, {0, 0, 1}));
  const double inside = 4.875e-7;  // a multiple of what doubles near 6 can tell apart
  const std::optional<double> grazing = depth(kSphere, {6 - inside, 2, -7}, {0, 0, 1});
  ASSERT_TRUE(grazing);
  EXPECT_NEAR(*grazing, 10 - std::sqrt(25 - (5 - inside) * (5 - inside)), 1e-11);
  EXPECT_FALSE(depth(kSphere, {1, 2, 9}, {0, 0, 1}));
}

}  // namespace
}  // namespace lute
