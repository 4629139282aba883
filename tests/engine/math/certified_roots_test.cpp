// The true number of roots comes from Sturm's sequence in exact rational arithmetic.
#include "engine/math/certified_roots.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace lute {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Exact = std::vector<Rational>;  // ascending

Exact exact(const std::vector<double>& c) {
  Exact e;
  for (const double v : c) e.emplace_back(v);
  while (!e.empty() && e.back() == 0) e.pop_back();
  return e;
}

int sign_at(const Exact& p, const Rational& t) {
  Rational f = 0;
  for (std::size_t i = p.size(); i-- > 0;) f = f * t + p[i];
  return f > 0 ? 1 : f < 0 ? -1 : 0;
}

// Number of different roots in (lo, hi].
int sturm_count(const std::vector<double>& c, double lo, double hi) {
  std::vector<Exact> sequence{exact(c), {}};
  for (std::size_t i = 1; i < sequence[0].size(); ++i) sequence[1].push_back(sequence[0][i] * static_cast<int>(i));
  while (sequence.back().size() > 1) {
    Exact rest = sequence[sequence.size() - 2];
    const Exact& by = sequence.back();
    while (rest.size() >= by.size()) {
      const Rational factor = rest.back() / by.back();
      for (std::size_t i = 1; i <= by.size(); ++i) rest[rest.size() - i] -= factor * by[by.size() - i];
      rest.pop_back();
    }
    while (!rest.empty() && rest.back() == 0) rest.pop_back();
    if (rest.empty()) break;
    for (Rational& v : rest) v = -v;
    sequence.push_back(rest);
  }
  const auto changes = [&](double at) {
    int count = 0, last = 0;
    for (const Exact& p : sequence) {
      const int sign = sign_at(p, Rational(at));
      if (sign != 0 && last != 0 && sign != last) ++count;
      if (sign != 0) last = sign;
    }
    return count;
  };
  return changes(lo) - changes(hi);
}

std::vector<double> list(const Roots<kMaxPolynomialDegree>& roots) { return {roots.begin(), roots.end()}; }

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

TEST(CertifiedRoots, RandomPolynomialsHaveAsManyAsSturmCounts) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> degrees(1, 12), digits(-20, 20);
  for (int i = 0; i < 400; ++i) {
    std::vector<double> c(static_cast<std::size_t>(degrees(random)) + 1);
    for (double& v : c) v = digits(random);
    if (c.back() == 0) c.back() = 1;
    EXPECT_EQ(static_cast<int>(certified_roots(c, {-3.1, 2.7}).count), sturm_count(c, -3.1, 2.7)) << "polynomial " << i;
  }
}

TEST(CertifiedRoots, AllOfAChebyshevPolynomialOfTheHighestDegree) {
  std::vector<double> before{1}, chebyshev{0, 1};  // T0, T1; T(n+1) = 2 t T(n) - T(n-1)
  for (int n = 1; n < static_cast<int>(kMaxPolynomialDegree); ++n) {
    std::vector<double> next = product({0, 2}, chebyshev);
    for (std::size_t k = 0; k < before.size(); ++k) next[k] -= before[k];
    before = std::exchange(chebyshev, next);
  }
  const std::vector<double> found = list(certified_roots(chebyshev, {-2, 2}));
  ASSERT_EQ(found.size(), kMaxPolynomialDegree);
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], -std::cos(std::acos(-1.0) * (static_cast<double>(k) + 0.5) / kMaxPolynomialDegree), 1e-6) << k;
}

TEST(CertifiedRoots, WilkinsonsPolynomial) {
  std::vector<double> c{1};
  for (int root = 1; root <= 14; ++root) c = product(c, {-static_cast<double>(root), 1});  // coefficients below 2^53
  const std::vector<double> found = list(certified_roots(c, {0, 100}));
  ASSERT_EQ(found.size(), 14u);
  for (std::size_t k = 0; k < 14; ++k) EXPECT_NEAR(found[k], static_cast<double>(k + 1), 2e-4);
}

TEST(CertifiedRoots, MultipleRootsAreOneRootInTheirPlace) {
  // (t - 3/4)^m (t + 2) (t - 5)
  for (int m = 2; m <= 6; ++m) {
    std::vector<double> c = product({2, 1}, {-5, 1});
    for (int i = 0; i < m; ++i) c = product(c, {-0.75, 1});
    const std::vector<double> found = list(certified_roots(c, {-10, 10}));
    ASSERT_EQ(found.size(), 3u) << m;
    EXPECT_NEAR(found[0], -2, 1e-12);
    EXPECT_NEAR(found[1], 0.75, 1e-9) << m;
    EXPECT_NEAR(found[2], 5, 1e-12);
  }
}

TEST(CertifiedRoots, NoneWhereThePolynomialStaysAway) {
  EXPECT_EQ(certified_roots(std::vector<double>{1e-12, 0, 1}, {-1, 1}).count, 0u);
  EXPECT_EQ(certified_roots(std::vector<double>{1e-30, 0, 1e-30, 0, 1e-30}, {-1, 1}).count, 0u);
  EXPECT_EQ(certified_roots(std::vector<double>{1}, {-1, 1}).count, 0u);
  EXPECT_EQ(certified_roots(std::vector<double>{0, 0, 0}, {-1, 1}).count, 0u);
}

TEST(CertifiedRoots, CloseRootsStaySeparateAtEveryScale) {
  for (const double scale : {1e-12, 1.0, 1e12}) {
    // (t - s) (t - s (1 + 2^-20)) (t^2 + s^2), exact in double precision for these s up to rounding of the coefficients.
    const double s = std::ldexp(1.0, std::ilogb(scale));
    const std::vector<double> c = product(product({-s, 1}, {-s * (1 + std::ldexp(1.0, -20)), 1}), {s * s, 0, 1});
    const std::vector<double> found = list(certified_roots(c, {0, 10 * s}));
    ASSERT_EQ(found.size(), 2u) << scale;
    EXPECT_NEAR(found[0] / s, 1, 1e-8);
    EXPECT_NEAR(found[1] / s, 1 + std::ldexp(1.0, -20), 1e-8);
  }
}

TEST(CertifiedRoots, RangeIsClosed) {
  const std::vector<double> c = product(product({0, 1}, {-1, 1}), product({-2, 1}, {-3, 1}));
  const std::vector<double> found = list(certified_roots(c, {1, 2}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], 1);
  EXPECT_EQ(found[1], 2);
}

TEST(CertifiedRoots, AgreeWithTheMonotoneStretches) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 500; ++i) {
    std::vector<double> c(static_cast<std::size_t>(5 + i % 12));
    for (double& v : c) v = unit(random);
    const auto a = list(certified_roots(c, {-4, 4})), b = list(solve_polynomial(c, {-4, 4}));
    ASSERT_EQ(a.size(), b.size()) << i;
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-11 * (1 + std::abs(a[k])));
  }
}

}  // namespace
}  // namespace lute
