#include "engine/shape/slope_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/function/program.hpp"

namespace lute {
namespace {

const Aabb kCube{dvec3(-1), dvec3(1)};

std::shared_ptr<const Function> sum_of_squares() {
  ExpressionBuilder e;
  const auto square = [&](int axis) { return e.binary(BinaryOp::kMultiply, e.parameter(axis), e.parameter(axis)); };
  return e.finish(e.binary(BinaryOp::kAdd, e.binary(BinaryOp::kAdd, square(0), square(1)), square(2)), 3);
}

TEST(SlopeTree, KnowsTheSteepestSlopeOfTheBox) {
  const double steepest = SlopeTree(sum_of_squares(), kCube).steepest();
  EXPECT_GE(steepest, 2 * std::sqrt(3.0));  // at the corners
  EXPECT_LT(steepest, 2 * std::sqrt(3.0) + 1e-5);
}

TEST(SlopeTree, PiecesCoverTheRayAndBoundTheFunctionHoweverFarItIsDivided) {
  const auto function = sum_of_squares();
  const SlopeTree tree(function, kCube);
  const Ray ray{{-3, 0.3, -0.2}, {2, 0.1, 0.2}};
  const Interval depths{1, 2};
  std::vector<SlopeTree::Piece> pieces;
  std::size_t most = 0;
  for (int round = 0; round < 400; ++round) {
    tree.along(ray, depths, pieces);
    most = std::max(most, pieces.size());
    ASSERT_EQ(pieces.back().end, depths.hi);
    double begin = depths.lo;
    for (auto& piece : pieces) {
      SlopeTree::find_slope(ray, piece);
      ASSERT_LE(begin, piece.end);
      for (const double t : {begin, 0.5 * (begin + piece.end), piece.end}) {
        const dvec3 p = ray.at(t);
        const double value = glm::dot(p, p), slope = 2 * glm::dot(p, ray.direction);
        EXPECT_LE(piece.value.lo, value);
        EXPECT_GE(piece.value.hi, value);
        EXPECT_LE(piece.slope.lo, slope);
        EXPECT_GE(piece.slope.hi, slope);
      }
      begin = piece.end;
      SlopeTree::too_wide(piece);
    }
  }
  EXPECT_GE(most, 32u);  // nodes of 1/16 along a way of 2
}

TEST(SlopeTree, KnowsNothingOfAFunctionWithoutEnclosure) {
  class Unknown final : public Function {
   public:
    Unknown() : Function(3, 1) {}
    void evaluate(const double* a, double* r) const override { *r = *a; }
  };
  EXPECT_FALSE(SlopeTree(std::make_shared<const Unknown>(), kCube).knows_function());
}

}  // namespace
}  // namespace lute
