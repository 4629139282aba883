// No expected numbers: many points at once must give, to the last bit, what they give one by one.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/function/internal_function.hpp"
#include "engine/function/program.hpp"

namespace lute {
namespace {

using B = BinaryOp;
using Node = ExpressionBuilder::Node;

constexpr std::size_t kCounts[] = {1, 3, 4, 31, 32, 33, 64, 1000};

// The sign and the payload of what is not a number are nobody's business.
bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b)); }

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint32_t seed) : random_(seed) {}
  unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
  // Often an integer, now and then no number that a formula likes.
  double number() {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    constexpr double kSpecial[] = {0.0, -0.0, kInfinite, -kInfinite, std::numeric_limits<double>::quiet_NaN(), 1e300, 5e-324};
    if (below(16) == 0) return kSpecial[below(7)];
    const double v = std::uniform_real_distribution<double>(-4, 4)(random_);
    return below(3) == 0 ? std::round(v) : v;
  }

 private:
  std::mt19937 random_;
};

void expect_same_one_by_one(const Function& function, RandomNumbers& random) {
  const auto parameters = static_cast<std::size_t>(function.parameter_count()), results = static_cast<std::size_t>(function.result_count());
  for (const std::size_t count : kCounts) {
    const std::size_t stride = count + random.below(3);
    std::vector<double> arguments(parameters * stride), many(results * stride, -77.0);
    for (double& a : arguments) a = random.number();
    function.evaluate_many(count, stride, arguments.data(), many.data());
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<double> point(parameters);
      for (std::size_t k = 0; k < parameters; ++k) point[k] = arguments[k * stride + i];
      std::array<double, 5> one{};
      function.evaluate(point.data(), one.data());
      for (std::size_t k = 0; k < results; ++k)
        ASSERT_TRUE(same(many[k * stride + i], one[k])) << many[k * stride + i] << " is not " << one[k] << ", point " << i << " of " << count;
    }
    for (std::size_t k = 0; k < results; ++k)
      for (std::size_t i = count; i < stride; ++i) ASSERT_EQ(many[k * stride + i], -77.0) << "what lies between two rows was written to";
  }
}

TEST(EvaluateMany, IsTheSameForEveryOperation) {
  RandomNumbers random(1);
  for (int op = 0; op <= static_cast<int>(UnaryOp::kLog); ++op) {
    SCOPED_TRACE(testing::Message() << "unary operation " << op);
    ExpressionBuilder e;
    expect_same_one_by_one(*e.finish(e.unary(static_cast<UnaryOp>(op), e.parameter(0)), 1), random);
  }
  for (int op = 0; op <= static_cast<int>(B::kMax); ++op) {
    SCOPED_TRACE(testing::Message() << "binary operation " << op);
    ExpressionBuilder e;
    expect_same_one_by_one(*e.finish(e.binary(static_cast<B>(op), e.parameter(0), e.parameter(1)), 2), random);
  }
}

TEST(EvaluateMany, IsTheSameForEveryInternalFunction) {
  RandomNumbers random(2);
  for (int index = 0; index <= 78; ++index) {
    SCOPED_TRACE(testing::Message() << "internal function " << index);
    expect_same_one_by_one(*internal_function(index, 2), random);
  }
}

// Expressions of everything that a function may contain, branches in loops in branches among it.
class RandomExpression {
 public:
  RandomExpression(RandomNumbers& random, const std::vector<FunctionPtr>& callees) : random_(random), callees_(callees) {}

  FunctionPtr make(unsigned parameters) {
    for (unsigned k = 0; k < parameters; ++k) leaves_.push_back(e_.parameter(k));
    return e_.finish(node(5), static_cast<int>(parameters));
  }

 private:
  Node leaf() { return random_.below(4) == 0 ? e_.constant(std::round(random_.number() * 8) / 8) : leaves_[random_.below(static_cast<unsigned>(leaves_.size()))]; }

  Node node(int depth) {
    if (depth == 0) return leaf();
    switch (random_.below(10)) {
      case 0: return leaf();
      case 1: return e_.unary(static_cast<UnaryOp>(random_.below(23)), node(depth - 1));
      case 2:
      case 3: return e_.select(node(depth - 1), node(depth - 1), node(depth - 1), node(depth - 1));
      case 4: {
        const Node to = node(depth - 1), other = node(depth - 1);
        return e_.select(to, other, leaf(), leaf());
      }
      case 5: return loop(depth);
      case 6: {
        const unsigned callee = random_.below(static_cast<unsigned>(callees_.size()));
        std::vector<Node> arguments;
        for (int k = 0; k < callees_[callee]->parameter_count(); ++k) arguments.push_back(node(depth > 2 ? 2 : depth - 1));
        return e_.call(callees_[callee], arguments);
      }
      default: {
        const auto op = static_cast<B>(random_.below(18));
        const Node a = node(depth - 1), b = node(depth - 1);
        return e_.binary(op == B::kDivide && e_.is_constant(b) ? B::kMultiply : op, a, b);
      }
    }
  }

  // From 1 to a small number that differs from point to point, or never.
  Node loop(int depth) {
    const Node limited = e_.binary(B::kMin, e_.constant(3), node(depth - 1));
    const Node variable = e_.local();
    leaves_.push_back(variable);
    const Node term = node(depth - 1);
    leaves_.pop_back();
    return random_.below(2) == 0 ? e_.sum(variable, e_.constant(1), limited, term) : e_.product(variable, e_.constant(1), limited, term);
  }

  RandomNumbers& random_;
  const std::vector<FunctionPtr>& callees_;
  ExpressionBuilder e_;
  std::vector<Node> leaves_;
};

TEST(EvaluateMany, IsTheSameForRandomProgramsThatCallEachOther) {
  RandomNumbers random(3);
  std::vector<FunctionPtr> callees = {internal_function(76, 2), internal_function(0, 2), internal_function(26, 2)};
  for (int i = 0; i < 300 && !testing::Test::HasFatalFailure(); ++i) {
    SCOPED_TRACE(testing::Message() << "program " << i);
    const FunctionPtr function = RandomExpression(random, callees).make(1 + random.below(3));
    expect_same_one_by_one(*function, random);
    if (function->work() < 4 && callees.size() < 20) callees.push_back(function);
  }
}

// Of 40 points every second takes the branch of a loop that would not end.
TEST(EvaluateMany, APointThatTakesAnotherBranchNeitherThrowsNorHangs) {
  ExpressionBuilder e;
  const auto x = e.parameter(0), i = e.local();
  const auto program = e.finish(e.select(x, e.sum(i, e.constant(1), e.parameter(1), i), e.constant(0), e.constant(0)), 2);
  std::vector<double> arguments(80), results(40);
  for (std::size_t p = 0; p < 40; ++p) {
    arguments[p] = p % 2 == 0 ? -1 : 1;
    arguments[40 + p] = p % 2 == 0 ? static_cast<double>(p) : 1e300;
  }
  program->evaluate_many(40, 40, arguments.data(), results.data());
  for (std::size_t p = 0; p < 40; ++p) EXPECT_EQ(results[p], p % 2 == 0 ? static_cast<double>(p * (p + 1) / 2) : 0) << p;
  arguments[7] = -1;
  EXPECT_THROW(program->evaluate_many(40, 40, arguments.data(), results.data()), EndlessFunction);
  arguments[7] = 1;
  EXPECT_NO_THROW(program->evaluate_many(40, 40, arguments.data(), results.data()));  // nothing is left of the loops that were given up
}

// 2^levels - 2 calls, if it is called at all.
FunctionPtr doubling(int levels) {
  FunctionPtr function;
  for (int level = 0; level < levels; ++level) {
    ExpressionBuilder e;
    const auto x = e.parameter(0);
    const Node other[] = {e.binary(B::kAdd, x, e.constant(1))}, itself[] = {x};
    function = e.finish(level == 0 ? x : e.binary(B::kAdd, e.call(function, itself), e.call(function, other)), 1);
  }
  return function;
}

// A call that counts 5.4e8 times, because it might call so much: 1e9 are allowed. Each point makes it once, at another turn of the loop, all
// together three times.
TEST(EvaluateMany, CallsAreCountedForEachPointAlone) {
  ExpressionBuilder inner_builder;
  const auto y = inner_builder.parameter(0);
  const Node itself[] = {y};
  const Node never = inner_builder.call(doubling(29), itself);
  const FunctionPtr inner = inner_builder.finish(inner_builder.select(y, never, y, y), 1);
  ExpressionBuilder e;
  const auto i = e.local();
  const Node arguments_of_call[] = {i};
  const auto call = e.call(inner, arguments_of_call);
  const auto away = e.unary(UnaryOp::kAbs, e.binary(B::kSubtract, i, e.parameter(0)));  // calls where this is below parameter 1
  const auto root = e.sum(i, e.constant(1), e.constant(3), e.select(e.binary(B::kSubtract, away, e.parameter(1)), call, e.constant(0), e.constant(0)));
  const FunctionPtr outer = e.finish(root, 2);
  std::vector<double> arguments(80, 0.5), results(40);
  for (std::size_t p = 0; p < 40; ++p) arguments[p] = static_cast<double>(1 + p % 3);
  outer->evaluate_many(40, 40, arguments.data(), results.data());
  for (std::size_t p = 0; p < 40; ++p) EXPECT_EQ(results[p], static_cast<double>(1 + p % 3)) << p;
  arguments[75] = 1.5;
  EXPECT_THROW(outer->evaluate_many(40, 40, arguments.data(), results.data()), EndlessFunction);
}

}  // namespace
}  // namespace lute
