// No expected numbers: what is enclosed must hold for points of the range, and a few enclosures are known to be tight.
#include "engine/function/enclosure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "engine/function/internal_function.hpp"

namespace lute {
namespace {

constexpr int kSamples = 40;

// One argument that stretches evenly from `from` to `from + slope * length` while the parameter stretches from 0 to `length`.
struct Stretch {
  double from, slope, length;
  double at(double s) const { return from + slope * s; }
  Enclosure enclosure() const { return {std::min(from, at(length)), std::max(from, at(length)), slope, slope}; }
};

// Values and difference quotients at points of the stretch lie in the enclosure.
template <class F>
void expect_encloses(const Enclosure& e, double length, F f) {
  double before = 0, before_at = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double s = length * i / kSamples, v = f(s);
    if (!std::isfinite(v)) {
      // Such an operation says that it knows nothing, or knows that nothing else comes out of it.
      EXPECT_FALSE(std::isfinite(e.lo) && std::isfinite(e.hi)) << v << " at " << s;
      return;
    }
    ASSERT_LE(e.lo, v) << "at " << s;
    ASSERT_GE(e.hi, v) << "at " << s;
    if (i > 0) {
      const double quotient = (v - before) / (s - before_at);
      const double rounding = 1e-13 * (std::abs(v) + std::abs(before) + 1) / (s - before_at);
      ASSERT_LE(e.slope_lo, quotient + rounding) << "at " << s;
      ASSERT_GE(e.slope_hi, quotient - rounding) << "at " << s;
    }
    before = v;
    before_at = s;
  }
}

class RandomStretches {
 public:
  Stretch next() {
    const double lengths[] = {1e-3, 0.1, 1, 4};
    return {5 * unit_(random_), unit_(random_), lengths[random_() % 4]};
  }
  double unit() { return unit_(random_); }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(Enclosure, HoldsForEveryFunctionOfOneArgument) {
  RandomStretches stretches;
  for (int op = 0; op <= static_cast<int>(UnaryOp::kLog); ++op)
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
      const Stretch a = stretches.next();
      SCOPED_TRACE(testing::Message() << "operation " << op << " of " << a.from << " to " << a.at(a.length));
      const auto unary = static_cast<UnaryOp>(op);
      expect_encloses(enclose(unary, a.enclosure()), a.length, [&](double s) { return apply(unary, a.at(s)); });
    }
}

TEST(Enclosure, HoldsForEveryFunctionOfTwoArguments) {
  RandomStretches stretches;
  for (int op = 0; op <= static_cast<int>(BinaryOp::kMax); ++op)
    for (int i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
      const Stretch a = stretches.next();
      Stretch b = stretches.next();
      b.length = a.length;
      if (i % 2 == 0) b.slope = 0;
      if (i % 4 == 0) b.from = std::floor(b.from);
      SCOPED_TRACE(testing::Message() << "operation " << op << " of " << a.from << " to " << a.at(a.length) << " and " << b.from << " to "
                                      << b.at(b.length));
      const auto binary = static_cast<BinaryOp>(op);
      expect_encloses(enclose(binary, a.enclosure(), b.enclosure()), a.length, [&](double s) { return apply(binary, a.at(s), b.at(s)); });
    }
}

TEST(Enclosure, HoldsForTheInternalFunctions) {
  RandomStretches stretches;
  int enclosed = 0;
  for (int index = 0; index < 76; ++index) {
    const FunctionPtr function = internal_function(index, 2);
    const std::vector<Enclosure> points(static_cast<std::size_t>(function->parameter_count()), Enclosure(1));
    Enclosure range;
    if (!function->enclose(points.data(), &range)) continue;
    ++enclosed;
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE(testing::Message() << "function " << index << ", stretch " << i);
      const double length = i % 2 == 0 ? 0.05 : 1.5;
      std::vector<Stretch> arguments;
      for (int k = 0; k < function->parameter_count(); ++k) {
        if (k < 3)
          arguments.push_back({2 * stretches.unit(), stretches.unit(), length});
        else
          arguments.push_back({0.2 + std::abs(stretches.unit()), 0, length});
      }
      std::vector<Enclosure> ranges;
      for (const Stretch& stretch : arguments) ranges.push_back(stretch.enclosure());
      ASSERT_TRUE(function->enclose(ranges.data(), &range));
      expect_encloses(range, length, [&](double s) {
        std::vector<double> values;
        for (const Stretch& stretch : arguments) values.push_back(stretch.at(s));
        double result = 0;
        function->evaluate(values.data(), &result);
        return result;
      });
    }
  }
  EXPECT_GT(enclosed, 40);
}

TEST(Enclosure, OfASquareKnowsThatBothFactorsAreTheSame) {
  const Enclosure x(-1, 2, 1, 1), square = x * x;
  EXPECT_NEAR(square.lo, 0, 1e-12);
  EXPECT_NEAR(square.hi, 4, 1e-12);
  EXPECT_NEAR(square.slope_lo, -2, 1e-12);
  EXPECT_NEAR(square.slope_hi, 4, 1e-12);
}

TEST(Enclosure, OfAQuotientByZeroIsUnbounded) {
  const Enclosure quotient = Enclosure(1) / Enclosure(-1, 1, 1, 1);
  EXPECT_EQ(quotient.lo, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(quotient.hi, std::numeric_limits<double>::infinity());
}

// select(x, -1, 1): both branches where the sign is not decided, one where it is.
TEST(ProgramEnclosure, FollowsBothBranchesOfAConditionThatIsNotDecided) {
  ExpressionBuilder e;
  const auto x = e.parameter(0);
  const auto program = e.finish(e.select(x, e.binary(BinaryOp::kMultiply, x, e.constant(-1)), e.constant(5), x), 1);
  Enclosure result;
  const Enclosure across(-2, 3, 1, 1), positive(2, 3, 1, 1);
  ASSERT_TRUE(program->enclose(&across, &result));
  EXPECT_LE(result.lo, 0);
  EXPECT_GE(result.hi, 5);
  EXPECT_EQ(result.steepest(), std::numeric_limits<double>::infinity());
  ASSERT_TRUE(program->enclose(&positive, &result));
  EXPECT_NEAR(result.lo, 2, 1e-12);
  EXPECT_NEAR(result.hi, 3, 1e-12);
  EXPECT_NEAR(result.steepest(), 1, 1e-12);
}

// sqrt(x² + (2 x)²) = √5 |x|: no steeper than √5 across 0 either, where the slope of a root alone is unbounded.
TEST(ProgramEnclosure, BoundsTheSlopeOfARootOfSquaresAcrossZero) {
  ExpressionBuilder e;
  const auto square = [&](ExpressionBuilder::Node a) { return e.binary(BinaryOp::kMultiply, a, a); };
  const auto x = e.parameter(0);
  const auto sum = e.binary(BinaryOp::kAdd, square(x), square(e.binary(BinaryOp::kMultiply, e.constant(2), x)));
  const auto program = e.finish(e.unary(UnaryOp::kSqrt, sum), 1);
  const auto less = e.finish(e.unary(UnaryOp::kSqrt, e.binary(BinaryOp::kSubtract, sum, e.constant(1))), 1);
  Enclosure result;
  const Enclosure across(-1, 2, 1, 1), beyond(0.44, 2, 1, 1);
  ASSERT_TRUE(program->enclose(&across, &result));
  EXPECT_NEAR(result.slope_lo, -std::sqrt(5.0), 1e-9);
  EXPECT_NEAR(result.slope_hi, std::sqrt(5.0), 1e-9);
  EXPECT_LE(result.lo, 0);
  // The root of 5 x² - 1 stands upright at x = 0.447.
  ASSERT_TRUE(less->enclose(&beyond, &result));
  EXPECT_EQ(result.steepest(), std::numeric_limits<double>::infinity());
}

// The sum of i * x for i = 1 to 4 is 10 x.
TEST(ProgramEnclosure, RunsLoops) {
  ExpressionBuilder e;
  const auto i = e.local();
  const auto program = e.finish(e.sum(i, e.constant(1), e.constant(4), e.binary(BinaryOp::kMultiply, i, e.parameter(0))), 1);
  Enclosure result;
  const Enclosure x(1, 2, 1, 1);
  ASSERT_TRUE(program->enclose(&x, &result));
  EXPECT_NEAR(result.lo, 10, 1e-9);
  EXPECT_NEAR(result.hi, 20, 1e-9);
  EXPECT_NEAR(result.slope_lo, 10, 1e-9);
}

TEST(ProgramEnclosure, SaysSoWhereNothingIsKnown) {
  class Unknown final : public Function {
   public:
    Unknown() : Function(1, 1) {}
    void evaluate(const double* a, double* r) const override { *r = *a; }
  };
  ExpressionBuilder e;
  const auto program = e.finish(e.call(std::make_shared<Unknown>(), std::vector{e.parameter(0)}), 1);
  Enclosure result;
  const Enclosure x(1, 2, 1, 1);
  EXPECT_FALSE(program->enclose(&x, &result));
}

}  // namespace
}  // namespace lute
