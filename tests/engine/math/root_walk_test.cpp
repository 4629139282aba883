// The roots of solve_quartic are the expected ones.
#include "engine/math/root_walk.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lute {
namespace {

std::vector<double> walked(const std::array<double, 5>& c, double width) {
  std::vector<double> roots;
  walk_roots(c, {0, width}, [&](double t) {
    roots.push_back(t);
    return false;
  });
  return roots;
}

std::array<double, 5> from_roots(double a, double b, double c, double d) {
  std::array<double, 5> p{1, 0, 0, 0, 0};
  for (const double r : {a, b, c, d}) {
    for (std::size_t i = 4; i > 0; --i) p[i] = p[i - 1] - r * p[i];
    p[0] *= -r;
  }
  return p;
}

TEST(RootWalk, FindsWhatTheMonotoneStretchesFind) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 5> c;
    for (double& v : c) v = unit(random);
    if (i % 2 == 0) c = from_roots(2 * unit(random), 2 * unit(random), 2 * unit(random), 2 * unit(random));
    const Roots<4> expected = solve_quartic(c, {0, 1.5});
    const std::vector<double> found = walked(c, 1.5);
    ASSERT_EQ(found.size(), expected.count) << i;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected.t[k], 1e-9) << i;
  }
}

TEST(RootWalk, KeepsDoubleRoots) {
  for (const double r : {0.25, 0.3, 0.75, 1.0}) {
    const std::vector<double> found = walked(from_roots(r, r, -1, 3), 2);
    ASSERT_EQ(found.size(), 1u) << r;
    EXPECT_NEAR(found[0], r, 1e-7);
  }
}

TEST(RootWalk, StopsWhenTheVisitorHasEnough) {
  int calls = 0;
  EXPECT_TRUE(walk_roots(from_roots(0.2, 0.5, 0.7, 0.9), {0, 1}, [&](double t) {
    EXPECT_NEAR(t, 0.2, 1e-12);
    return ++calls == 1;
  }));
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace lute
