// Quartics with double, triple and clustered roots: the solver against roots worked out with 113 bits.
//
// The oracle takes the coefficients as they are, doubles, since rounding them already moves roots: a root of multiplicity m by
// about the m-th root of 1e-16. What is asked of the solver is what its own arithmetic allows. Where the polynomial is
// away from zero by more than the rounding of its terms, its sign is certain: so every change of sign of the true
// polynomial between two such places needs a root there, and a root may only be said to be where the polynomial is zero
// but for that rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "engine/math/polynomial.hpp"
#include "tests/extreme/real.hpp"

namespace lute::extreme {
namespace {

using Quartic = std::array<double, 5>;

constexpr Interval kEverywhere{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
constexpr double kUnit = 1.1102230246251565e-16;  // 2^-53
// Units of rounding: two for each of the four steps of Horner's rule, as many again for the value at the next double beside
// the root, and as many for each of the derivatives' roots that bound the stretch.
constexpr double kRoundings = 32;

Real value(const Quartic& c, Real t) {
  Real sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
  return sum;
}

// What rounding can make of it.
Real blur(const Quartic& c, Real t) {
  Real sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * magnitude(t) + magnitude(c[i]);
  return kRoundings * kUnit * sum;
}

// leading (t - r0)(t - r1)(t - r2)(t - r3), each coefficient rounded once.
Quartic from_roots(const std::array<double, 4>& roots, double leading) {
  std::array<Real, 5> c{leading};
  for (std::size_t count = 1; count <= roots.size(); ++count) {
    for (std::size_t i = count; i > 0; --i) c[i] = c[i - 1] - roots[count - 1] * c[i];
    c[0] *= -Real{roots[count - 1]};
  }
  Quartic rounded;
  for (std::size_t i = 0; i < rounded.size(); ++i) rounded[i] = static_cast<double>(c[i]);
  return rounded;
}

// Places between which the true polynomial certainly changes its sign: from a fine grid around the roots that it was
// built from, whose cells shrink towards each of them.
std::vector<double> places(std::array<double, 4> roots) {
  std::vector<double> all;
  for (const double root : roots) {
    for (const double other : roots) all.push_back(0.5 * (root + other));
    const double size = std::max(std::abs(root), 1e-3);
    for (int step = -52; step <= 4; ++step) {
      all.push_back(root + std::ldexp(size, step));
      all.push_back(root - std::ldexp(size, step));
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_the_true_roots(const Quartic& c, const std::array<double, 4>& built_from) {
  const Roots<4> found = solve_quartic(c, kEverywhere);
  for (const double t : found) {
    EXPECT_LE(static_cast<double>(magnitude(value(c, t))), static_cast<double>(blur(c, t))) << "invented: " << t;
  }
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  double before = 0;
  int sign_before = 0;
  for (const double t : places(built_from)) {
    const Real f = value(c, t);
    if (magnitude(f) <= blur(c, t)) continue;
    const int sign = f > 0 ? 1 : -1;
    if (sign_before == -sign) {
      const auto inside = [&](double root) { return before <= root && root <= t; };
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), inside)) << "lost: between " << before << " and " << t;
    }
    before = t;
    sign_before = sign;
  }
}

// Roots at random, of which some are moved to `gap` times a random number from the first.
void expect_clusters(int clustered, double gap, int quartics) {
  std::mt19937_64 random(17 + static_cast<std::uint64_t>(clustered));
  std::uniform_real_distribution<double> unit(-1, 1), exponent(-6, 6);
  for (int i = 0; i < quartics && !testing::Test::HasFailure(); ++i) {
    const double scale = std::pow(10.0, exponent(random));
    std::array<double, 4> roots;
    for (double& root : roots) root = scale * unit(random);
    for (std::size_t k = 1; k < static_cast<std::size_t>(clustered); ++k) roots[k] = roots[0] * (1 + gap * unit(random));
    SCOPED_TRACE(testing::Message() << "quartic " << i << ": roots " << roots[0] << ' ' << roots[1] << ' ' << roots[2] << ' '
                                    << roots[3]);
    expect_the_true_roots(from_roots(roots, std::pow(10.0, exponent(random))), roots);
  }
}

TEST(QuarticRoots, SimpleOnesAreFoundAtEveryScale) { expect_clusters(1, 0, 5000); }

TEST(QuarticRoots, DoubleOnesKeepWhatTheirSignsSay) { expect_clusters(2, 0, 5000); }

TEST(QuarticRoots, TripleOnesAreNeverLost) { expect_clusters(3, 0, 5000); }

TEST(QuarticRoots, FourfoldOnesAreNotInvented) { expect_clusters(4, 0, 5000); }

TEST(QuarticRoots, ClustersOfTwoThreeAndFour) {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const int clustered : {2, 3, 4}) expect_clusters(clustered, gap, 1500);
  }
}

// All coefficients are exact doubles, so the root is double in truth, and the polynomial does not change its sign there. Not
// at 0: nothing is seen where a ray begins.
TEST(QuarticRoots, ExactDoubleRootsTouchAndAreKept) {
  std::mt19937 random(23);
  std::uniform_int_distribution<int> quarters(1, 80);
  for (int i = 0; i < 20000; ++i) {
    const double touched = 0.25 * quarters(random);
    const std::array<double, 4> roots{touched, touched, 0.25 * quarters(random), -0.25 * quarters(random)};
    const Roots<4> found = solve_quartic(from_roots(roots, 1), kEverywhere);
    for (const double root : roots) {
      // 1e-5 is the cube root of the rounding, for those that happen to be triple.
      const bool kept = std::any_of(found.begin(), found.end(),
                                    [&](double t) { return std::abs(t - root) <= 1e-4 * std::max(1.0, std::abs(root)); });
      EXPECT_TRUE(kept) << "roots " << roots[0] << ' ' << roots[1] << ' ' << roots[2] << ' ' << roots[3];
    }
  }
}

}  // namespace
}  // namespace lute::extreme
