// The gradient of x² + y² + z² has the length 2 r: a limit g is enough within the ball of radius g / 2.
#include "engine/shape/slope_proof.hpp"

#include <gtest/gtest.h>

#include "engine/function/program.hpp"

namespace lute {
namespace {

const Aabb kCube{dvec3(-1), dvec3(1)};

FunctionPtr sum_of_squares() {
  ExpressionBuilder e;
  const auto square = [&](int axis) { return e.binary(BinaryOp::kMultiply, e.parameter(axis), e.parameter(axis)); };
  return e.finish(e.binary(BinaryOp::kAdd, e.binary(BinaryOp::kAdd, square(0), square(1)), square(2)), 3);
}

std::vector<Interval> doubtful(const SlopeProof& proof, const Ray& ray, Interval depths) {
  std::vector<Interval> stretches;
  proof.doubtful(ray, depths, stretches);
  return stretches;
}

TEST(SlopeProof, HoldsEverywhereWhereTheLimitIsThatOfTheCorners) {
  const auto function = sum_of_squares();
  EXPECT_TRUE(SlopeProof(*function, kCube, 3.47).everywhere());  // 2 √3 = 3.464
  EXPECT_FALSE(SlopeProof(*function, kCube, 3.46).everywhere());
}

TEST(SlopeProof, DoubtsTheEndsOfARayThroughTheMiddle) {
  const auto function = sum_of_squares();
  const SlopeProof proof(*function, kCube, 1);
  // Along x at y = z = 0.05, the slope exceeds 1 where |x| > 0.495; cells are 0.125 wide.
  const auto stretches = doubtful(proof, {{-3, 0.05, 0.05}, {1, 0, 0}}, {2, 4});
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_NEAR(stretches[0].lo, 2, 1e-6);
  EXPECT_GE(stretches[0].hi, 3 - 0.495);
  EXPECT_LE(stretches[0].hi, 3 - 0.495 + 0.25);
  EXPECT_LE(stretches[1].lo, 3 + 0.495);
  EXPECT_GE(stretches[1].lo, 3 + 0.495 - 0.25);
  EXPECT_NEAR(stretches[1].hi, 4, 1e-6);
}

TEST(SlopeProof, DoubtsNothingWhereNothingIsKnown) {
  class Unknown final : public Function {
   public:
    Unknown() : Function(3, 1) {}
    void evaluate(const double* a, double* r) const override { *r = *a; }
  } function;
  const SlopeProof proof(function, kCube, 0.5);
  EXPECT_FALSE(proof.possible());
  EXPECT_TRUE(doubtful(proof, {{-3, 0, 0}, {1, 0, 0}}, {2, 4}).empty());
}

}  // namespace
}  // namespace lute
