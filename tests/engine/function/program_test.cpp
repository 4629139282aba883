#include "engine/function/program.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace lute {
namespace {

using B = BinaryOp;
using Args = std::vector<double>;

double value(const Function& function, const Args& arguments) {
  double result = 0;
  function.evaluate(arguments.data(), &result);
  return result;
}

// Specification chapter 10 §14, check case 13.
TEST(Program, DividesByAConstantThroughItsReciprocal) {
  ExpressionBuilder e;
  const auto program = e.finish(e.binary(B::kDivide, e.parameter(0), e.constant(3)), 1);
  EXPECT_EQ(value(*program, Args{5}), 1.666666666666666519);
}

TEST(Program, SumsSquares) {
  ExpressionBuilder e;
  const auto i = e.local();
  const auto program = e.finish(e.sum(i, e.constant(1), e.parameter(0), e.binary(B::kMultiply, i, i)), 1);
  EXPECT_EQ(value(*program, Args{4}), 30);
  EXPECT_EQ(value(*program, Args{0}), 0);
}

TEST(Program, SumsThatWouldNotEndAreRefused) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  ExpressionBuilder e;
  const auto i = e.local();
  const auto sum = e.finish(e.sum(i, e.parameter(0), e.parameter(1), i), 2);
  EXPECT_EQ(value(*sum, Args{1, 1e6}), 500000500000.0);
  EXPECT_EQ(value(*sum, Args{1e300, 1}), 0);
  EXPECT_EQ(value(*sum, Args{1, std::nan("")}), 0);
  for (const Args& ends : {Args{1, 1e30}, Args{1, kInfinite}, Args{-kInfinite, 1}, Args{kInfinite, kInfinite}, Args{1e20, 1e20}}) {
    EXPECT_THROW(value(*sum, ends), EndlessFunction) << ends[0] << " " << ends[1];
  }
  EXPECT_EQ(value(*sum, Args{1, 3}), 6);  // nothing is left of the loops that were given up
}

TEST(Program, LoopsOfFunctionsThatCallEachOtherCountTogether) {
  ExpressionBuilder inner_builder;
  const auto j = inner_builder.local();
  const auto inner = inner_builder.finish(inner_builder.sum(j, inner_builder.constant(1), inner_builder.constant(6e8), j), 0);
  ExpressionBuilder e;
  const auto i = e.local();
  const auto call = e.call(inner, {});
  const auto outer = e.finish(e.sum(i, e.constant(1), e.constant(6e8), e.binary(B::kMultiply, i, call)), 0);
  EXPECT_THROW(value(*outer, Args{}), EndlessFunction);
}

// Each function calls the one before it twice, with arguments of its own.
FunctionPtr twice_of_twice(int levels, bool one_of_two) {
  FunctionPtr function;
  for (int level = 0; level < levels; ++level) {
    ExpressionBuilder e;
    const auto x = e.parameter(0);
    if (level == 0) {
      function = e.finish(x, 1);
      continue;
    }
    const ExpressionBuilder::Node other[] = {e.binary(B::kAdd, x, e.constant(1))}, same[] = {x};
    const auto a = e.call(function, same), b = e.call(function, other);
    function = e.finish(one_of_two ? e.select(x, a, b, b) : e.binary(B::kAdd, a, b), 1);
  }
  return function;
}

TEST(Program, CallsThatDoubleAreCountedLikeTurns) {
  EXPECT_EQ(twice_of_twice(11, false)->work(), 2046);  // 2 + 4 + ... + 1024
  EXPECT_EQ(value(*twice_of_twice(2, false), Args{1}), 3);
  EXPECT_NO_THROW(value(*twice_of_twice(16, false), Args{1}));
  EXPECT_THROW(value(*twice_of_twice(60, false), Args{1}), EndlessFunction);
  EXPECT_EQ(value(*twice_of_twice(2, false), Args{1}), 3);  // nothing is left of the calls that were given up
}

TEST(Program, OnlyOneBranchOfASelectCalls) {
  const FunctionPtr function = twice_of_twice(61, true);
  EXPECT_EQ(function->work(), 60);
  EXPECT_EQ(value(*function, Args{-1}), -1);
  EXPECT_EQ(value(*function, Args{1}), 61);
}

TEST(Program, KnowsHowDeepItCalls) { EXPECT_EQ(twice_of_twice(7, false)->depth(), 7u); }

TEST(Program, EmptyProductIsOne) {
  ExpressionBuilder e;
  const auto i = e.local();
  EXPECT_EQ(value(*e.finish(e.product(i, e.constant(1), e.parameter(0), i), 1), Args{0}), 1);
  EXPECT_EQ(value(*e.finish(e.product(i, e.constant(1), e.parameter(0), i), 1), Args{5}), 120);
}

// Chapter 21 §11.2: a<3=1 is evaluated as a<(3=1); parentheses keep their meaning.
TEST(Program, FoldsNeighbouringConstantsOfOneLevel) {
  ExpressionBuilder e;
  const auto less = e.binary(B::kLess, e.parameter(0), e.constant(3));
  const auto folded = e.finish(e.binary(B::kEqual, less, e.constant(1)), 1);
  EXPECT_EQ(value(*folded, Args{1}), 0);
  EXPECT_EQ(value(*folded, Args{-1}), 1);
  const auto grouped = e.finish(e.binary(B::kEqual, e.group(less), e.constant(1)), 1);
  EXPECT_EQ(value(*grouped, Args{1}), 1);
}

// Chapter 21 §11.2: g(1)/2*3 with g(1) = 4 is 0.6667, g(x)/2*3 is 6.
TEST(Program, FoldsProductsOnlyWhereNoParameterStandsToTheLeft) {
  ExpressionBuilder inner;
  const auto g = inner.finish(inner.binary(B::kAdd, inner.parameter(0), inner.constant(3)), 1);
  for (const bool constant_argument : {true, false}) {
    ExpressionBuilder e;
    const auto argument = constant_argument ? e.constant(1) : e.parameter(0);
    const auto call = e.call(g, std::vector{argument});
    const auto root = e.binary(B::kMultiply, e.binary(B::kDivide, call, e.constant(2)), e.constant(3));
    EXPECT_NEAR(value(*e.finish(root, 1), Args{1}), constant_argument ? 4.0 / 6 : 6.0, 1e-15);
  }
}

TEST(Program, SelectRunsOnlyTheChosenBranch) {
  ExpressionBuilder e;
  const auto x = e.parameter(0);
  const auto root = e.select(x, e.constant(-1), e.constant(0), e.unary(UnaryOp::kSqrt, x));
  const auto program = e.finish(root, 1);
  EXPECT_EQ(value(*program, Args{-4}), -1);
  EXPECT_EQ(value(*program, Args{0}), 0);
  EXPECT_EQ(value(*program, Args{9}), 3);
}

// What one branch has computed is not known in the other.
TEST(Program, BranchesDoNotShareRegisters) {
  ExpressionBuilder e;
  const auto x = e.parameter(0);
  const auto square = e.binary(B::kMultiply, x, x);
  const auto root = e.binary(B::kAdd, e.select(x, square, e.constant(7), e.constant(7)), square);
  EXPECT_EQ(value(*e.finish(root, 1), Args{3}), 16);
  EXPECT_EQ(value(*e.finish(root, 1), Args{-3}), 18);
}

TEST(Program, ComputesEqualSubexpressionsOnce) {
  ExpressionBuilder e;
  const auto s = e.unary(UnaryOp::kSin, e.parameter(0));
  const auto t = e.unary(UnaryOp::kSin, e.parameter(0));
  EXPECT_EQ(e.finish(e.binary(B::kAdd, s, t), 1)->instruction_count(), 2u);
}

TEST(Program, SmallPowersAreMultiplications) {
  ExpressionBuilder e;
  for (int k = 0; k <= 9; ++k) {
    const auto program = e.finish(e.binary(B::kPow, e.parameter(0), e.constant(k)), 1);
    EXPECT_NEAR(value(*program, Args{1.1}), std::pow(1.1, k), 1e-14) << k;
  }
}

// Domain errors yield IEEE results, also of constants; measured with the reference: x/0 is refused, 1/0, x/(1-1) and ln(0) are not.
TEST(Program, DomainErrorsAreIeeeAndOnlyDivisionByAWrittenZeroIsRefused) {
  ExpressionBuilder e;
  EXPECT_EQ(value(*e.finish(e.unary(UnaryOp::kLn, e.parameter(0)), 1), Args{0}), -INFINITY);
  EXPECT_EQ(value(*e.finish(e.unary(UnaryOp::kLn, e.constant(0)), 1), Args{0}), -INFINITY);
  EXPECT_EQ(value(*e.finish(e.binary(B::kDivide, e.constant(1), e.constant(0)), 1), Args{0}), INFINITY);
  const auto computed_zero = e.binary(B::kSubtract, e.constant(1), e.constant(1));
  EXPECT_EQ(value(*e.finish(e.binary(B::kDivide, e.parameter(0), computed_zero), 1), Args{1}), INFINITY);
  EXPECT_THROW(e.binary(B::kDivide, e.parameter(0), e.constant(0)), ConstantDomainError);
}

TEST(Program, NanCountsAsGreater) {
  EXPECT_EQ(apply(B::kGreater, NAN, 1), 1);
  EXPECT_EQ(apply(B::kLessEqual, NAN, 1), 0);
  EXPECT_EQ(apply(B::kNotEqual, NAN, NAN), 1);
}

}  // namespace
}  // namespace lute
