#include "engine/shape/bounding_balls.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "engine/math/vec.hpp"

namespace lute {
namespace {

class BoundingBallsAtScale : public testing::TestWithParam<double> {};

// Against the distance of each centre in double precision. Balls of very different sizes, seen from near and from far.
TEST_P(BoundingBallsAtScale, LosesNoneAndVisitsFewBeside) {
  const double scale = GetParam();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto place = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  const dvec3 middle = scale * dvec3(3, -70, 20);
  std::vector<BoundingBalls::Ball> balls;
  for (int i = 0; i < 13; ++i) balls.push_back({middle + scale * place(), scale * (i % 4 == 0 ? 1e-4 : 0.2)});
  const BoundingBalls bounding(balls);
  int met = 0, visited = 0;
  for (int i = 0; i < 4000; ++i) {
    const double far = i % 2 == 0 ? 2 : 1e5;
    const dvec3 aim = balls[static_cast<std::size_t>(i) % balls.size()].center + scale * (i % 3 == 0 ? 1e-4 : 0.3) * place();
    const dvec3 origin = middle + far * scale * place();
    const Ray ray{origin, 7.0 * glm::normalize(aim - origin)};  // of any length
    std::vector<bool> seen(balls.size(), false);
    bounding.for_each_near(ray, [&](std::size_t b) { seen.at(b) = true; });
    for (std::size_t b = 0; b < balls.size(); ++b) {
      const double distance = glm::length(glm::cross(glm::normalize(ray.direction), balls[b].center - aim));
      met += distance <= balls[b].radius;
      visited += seen[b];
      ASSERT_TRUE(seen[b] || distance > balls[b].radius * (1 - 1e-6)) << "ray " << i << ", ball " << b;
    }
    std::vector<bool> around(balls.size(), false);
    bounding.for_each_at(aim, [&](std::size_t b) { around.at(b) = true; });
    for (std::size_t b = 0; b < balls.size(); ++b)
      ASSERT_TRUE(around[b] || glm::length(aim - balls[b].center) > balls[b].radius * (1 - 1e-6)) << "point " << i << ", ball " << b;
  }
  EXPECT_GT(met, 2000);
  EXPECT_LT(visited, 1.05 * met);
}

INSTANTIATE_TEST_SUITE_P(Scales, BoundingBallsAtScale, testing::Values(1e-30, 1e-5, 1.0, 1e5, 1e30));

TEST(BoundingBalls, BeyondMeasureHideNoOthers) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double far : {1e160, 1e308, inf}) {
    const BoundingBalls balls({{dvec3(0), 1}, {dvec3(far, 0, 0), 1}});
    int seen = 0;
    balls.for_each_near({dvec3(0, 0, -5), dvec3(0, 0, 1)}, [&](std::size_t i) { seen += i == 0; });
    balls.for_each_at(dvec3(0.5), [&](std::size_t i) { seen += i == 0; });
    EXPECT_EQ(seen, 2) << far;
  }
}

TEST(BoundingBalls, OfNothingVisitNothing) {
  int visited = 0;
  BoundingBalls().for_each_near({dvec3(0), dvec3(0, 0, 1)}, [&](std::size_t) { ++visited; });
  BoundingBalls().for_each_at(dvec3(0), [&](std::size_t) { ++visited; });
  EXPECT_EQ(visited, 0);
}

}  // namespace
}  // namespace lute
