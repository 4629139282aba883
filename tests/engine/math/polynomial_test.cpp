// Expected roots are those the polynomials are built from.
#include "engine/math/polynomial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace lute {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr Interval kEverywhere{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

std::vector<double> from_roots(const std::vector<double>& roots) {
  std::vector<double> c{1};
  for (const double r : roots) {
    c.push_back(0);
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - r * c[i];
    c[0] *= -r;
  }
  return c;
}

template <std::size_t N>
std::array<double, N> fixed(const std::vector<double>& c) {
  std::array<double, N> a{};
  std::copy(c.begin(), c.end(), a.begin());
  return a;
}

template <std::size_t N>
std::vector<double> list(const Roots<N>& roots) {
  return {roots.begin(), roots.end()};
}

TEST(Polynomial, QuadraticKeepsTheSmallRoot) {
  EXPECT_THAT(list(solve_quadratic({1e-8, -1e8, 1}, kEverywhere)), ElementsAre(DoubleNear(1e-16, 1e-30), DoubleNear(1e8, 1e-6)));
}

TEST(Polynomial, QuadraticWithoutSquareIsLinear) {
  EXPECT_THAT(list(solve_quadratic({-6, 2, 0}, kEverywhere)), ElementsAre(3.0));
}

TEST(Polynomial, TripleRootIsKept) { EXPECT_THAT(list(solve_cubic({0, 0, 0, 1}, kEverywhere)), ElementsAre(0.0)); }

TEST(Polynomial, TripleRootAwayFromZero) {
  EXPECT_THAT(list(solve_cubic(fixed<4>(from_roots({2, 2, 2})), kEverywhere)), ElementsAre(DoubleNear(2, 1e-4)));
}

TEST(Polynomial, DoubleRootOfQuarticIsKept) {
  EXPECT_THAT(list(solve_quartic(fixed<5>(from_roots({-3, 1.1, 1.1, 2.7})), kEverywhere)),
              ElementsAre(DoubleNear(-3, 1e-12), DoubleNear(1.1, 1e-7), DoubleNear(2.7, 1e-12)));
}

TEST(Polynomial, NoRootsOffTheAxis) {
  EXPECT_THAT(list(solve_quartic({1e-9, 0, 2, 0, 1}, kEverywhere)), ElementsAre());
}

TEST(Polynomial, RangeIsClosed) {
  EXPECT_THAT(list(solve_quartic(fixed<5>(from_roots({0, 1, 2, 3})), {1, 2})), ElementsAre(1.0, 2.0));
}

TEST(Polynomial, RandomQuarticsGiveTheirRootsAtEveryScale) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int exponent = -8; exponent <= 8; ++exponent) {
    const double s = std::pow(10.0, exponent);
    for (int i = 0; i < 500; ++i) {
      std::vector<double> expected(4);
      for (double& r : expected) r = s * unit(random);
      std::sort(expected.begin(), expected.end());
      double gap = 1;
      for (std::size_t k = 1; k < 4; ++k) gap = std::min(gap, (expected[k] - expected[k - 1]) / s);
      if (gap < 1e-3) continue;
      const std::vector<double> found = list(solve_quartic(fixed<5>(from_roots(expected)), kEverywhere));
      ASSERT_EQ(found.size(), 4u);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k] / s, expected[k] / s, 1e-6);
    }
  }
}

// A quartic that is nearly a quadratic: two roots nearby, two so far away that the closed form for its splits would drown the near
// ones.
TEST(Polynomial, QuarticWithFarRootsKeepsTheNearOnes) {
  for (double far = 1e2; far <= 1e14; far *= 10) {
    const std::vector<double> c = from_roots({-far, 0.25, 1.5, 2 * far});
    const std::vector<double> found = list(solve_quartic(fixed<5>(c), {-10, 10}));
    ASSERT_EQ(found.size(), 2u) << far;
    EXPECT_NEAR(found[0], 0.25, 1e-12) << far;
    EXPECT_NEAR(found[1], 1.5, 1e-12) << far;
  }
}

// The range of a ray is as long as a scene may be.
TEST(Polynomial, LongRangeLosesNothing) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> expected(4);
    for (double& r : expected) r = 3 + unit(random);
    std::sort(expected.begin(), expected.end());
    double gap = 1;
    for (std::size_t k = 1; k < 4; ++k) gap = std::min(gap, expected[k] - expected[k - 1]);
    if (gap < 1e-2) continue;
    const std::vector<double> found = list(solve_quartic(fixed<5>(from_roots(expected)), {1e-4, 1e7}));
    ASSERT_EQ(found.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k], expected[k], 1e-7);
    EXPECT_EQ(list(solve_quartic(fixed<5>(from_roots(expected)), {-1e7, 2})).size(), 0u);
  }
}

TEST(Polynomial, HighDegree) {
  const std::vector<double> expected{-2, -1.5, -.75, -.1, .2, .9, 1.3, 1.9, 2.5, 3};
  const std::vector<double> found = list(solve_polynomial(from_roots(expected), kEverywhere));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-9);
}

TEST(Polynomial, BernsteinSignsExcludeRoots) {
  EXPECT_FALSE(may_have_root(std::array<double, 3>{1, 0, 1}, {-.5, .5}));
  EXPECT_TRUE(may_have_root(std::array<double, 3>{-1, 0, 1}, {0, 3}));
}

}  // namespace
}  // namespace lute
