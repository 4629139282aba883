#include "engine/math/transform.hpp"

#include <gtest/gtest.h>

namespace lute {
namespace {

void expect_near(const dvec3& actual, const dvec3& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

// Specification chapter 10 §14, check case 6: vrotate(<1,2,3>,<10,20,30>).
TEST(Transform, RotatesAboutXThenYThenZLeftHanded) {
  expect_near(Transform::rotate({10, 20, 30}).point({1, 2, 3}), {1.067425, 2.289059, 2.760581}, 5e-7);
}

TEST(Transform, ThenAppliesInWritingOrder) {
  const Transform t = Transform::translate({1, 2, 3}).then(Transform::scale({2, 2, 2}));
  expect_near(t.point({1, 1, 1}), {4, 6, 8}, 0);  // chapter 10 §14, check case 13
  EXPECT_EQ(t.kinds, Transform::kTranslate | Transform::kUniformScale);
}

TEST(Transform, InverseUndoesEveryKind) {
  const Transform t = Transform::rotate({10, -70, 33})
                          .then(Transform::scale({2, 0.5, 3}))
                          .then(Transform::translate({5, -1, 2}))
                          .then(Transform::matrix(dmat3(1, 2, 0, 0, 1, 4, 5, 0, 1), {7, 8, 9}));
  const dvec3 p{0.3, -4, 2.5};
  expect_near(t.inverse_point(t.point(p)), p, 1e-12);
  expect_near(t.inverse().point(t.point(p)), p, 1e-12);
}

TEST(Transform, RemembersFlipsBeforeTheFirstTurnOnly) {
  const Transform flip_x = Transform::scale({-1, 2, 1}), turn = Transform::rotate({0, 30, 0}), flip_yx = Transform::scale({-1, -3, 1});
  EXPECT_EQ(flip_x.then(turn).then(flip_yx).flips, 1);
  EXPECT_EQ(flip_x.then(Transform::translate({1, 2, 3})).then(flip_yx).then(turn).flips, 2);
  EXPECT_EQ(turn.then(flip_x).flips, 0);
  EXPECT_EQ(flip_x.then(turn.then(flip_x)).flips, 1);  // what an enclosing object adds is one transformation here
  EXPECT_EQ(flip_x.as_matrix().flips, 0);
  EXPECT_EQ(flip_x.then(flip_x.as_matrix()).flips, 1);
}

TEST(Transform, NormalStaysPerpendicularUnderUnevenScale) {
  const Transform t = Transform::scale({1, 4, 1});
  const dvec3 tangent = t.direction({1, -1, 0});
  EXPECT_NEAR(glm::dot(tangent, t.normal({1, 1, 0})), 0, 1e-15);
}

TEST(Transform, SingularMatrixIsToldApart) {
  EXPECT_FALSE(Transform::matrix(dmat3(0.0), {0, 0, 0}).invertible());
  EXPECT_TRUE(Transform::rotate({1, 2, 3}).invertible());
}

TEST(Transform, BoxOfInfiniteBoxStaysInfinite) {
  EXPECT_FALSE(Transform::translate({1, 0, 0}).box(Aabb::infinite()).is_finite());
}

}  // namespace
}  // namespace lute
