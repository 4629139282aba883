// Expected numbers: specification chapter 20 §12, check cases 2 and 3.
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "engine/shape/lathe.hpp"
#include "engine/shape/ovus.hpp"
#include "engine/shape/prism.hpp"
#include "engine/shape/sor.hpp"
#include "engine/shape/sphere_sweep.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using test::trace;

const dvec3 kZ(0, 0, 1);

#define EXPECT_FRONT(description, x, y, z, n) EXPECT_TRACE(*make(description), dvec3(x, y, -5), kZ, dvec3(x, y, z), n)

const Sor kVase{{{0, -1}, {.5, 0}, {1, .5}, {.6, 1}, {.4, 1.6}, {0, 2}}};

TEST(Sor, Traces) {
  EXPECT_FRONT(kVase, .1, .7, -0.900299, dvec3(0.081444, 0.675071, -0.733244));
  EXPECT_FRONT(kVase, .1, .25, -0.802600, dvec3(0.076974, -0.782566, -0.617791));
}

TEST(Sor, OpenHasNoDiscs) {
  Sor open = kVase;
  open.open = true;
  EXPECT_TRACE(*make(kVase), dvec3(.1, 5, 0), dvec3(0, -1, 0), dvec3(.1, 1.6, 0), dvec3(0, 1, 0));
  const auto traced = trace(*make(open), {.1, 5, 0}, {0, -1, 0});
  EXPECT_FALSE(traced);
}

TEST(Lathe, TracesEverySpline) {
  EXPECT_FRONT((Lathe{PlanarSpline::kLinear, {{.5, -1}, {1, 0}, {.25, 1}}}), .1, .5, -0.616948, dvec3(0.128, 0.6, -0.789694));
  EXPECT_FRONT((Lathe{PlanarSpline::kQuadratic, {{.2, -2}, {.5, -1}, {1, 0}, {.25, 1}}}), .1, .5, -0.774824,
               dvec3(0.102400, 0.6, -0.793419));
  EXPECT_FRONT((Lathe{PlanarSpline::kCubic, {{.2, -2}, {.5, -1}, {1, 0}, {.25, 1}, {0, 2}}}), .1, .5, -0.664391,
               dvec3(0.106901, 0.695795, -0.710240));
  EXPECT_FRONT((Lathe{PlanarSpline::kBezier, {{.5, -1}, {1.5, -.5}, {1, .5}, {.25, 1}}}), .1, .5, -0.775796,
               dvec3(0.102473, 0.597922, -0.794977));
}

TEST(Lathe, LevelAndNearlyLevelRaysAgree) {
  const auto shape = make(Lathe{PlanarSpline::kBezier, {{.5, -1}, {1.5, -.5}, {1, .5}, {.25, 1}}});
  for (const double slope : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12, 0.0}) {
    ShapeHits hits;
    shape->hits({{.1, .5 - 5 * slope, -5}, glm::normalize(dvec3(0, slope, 1))}, {0, 100}, hits);
    ASSERT_EQ(hits.size(), 2u) << slope;
    EXPECT_NEAR(std::min(hits[0].t, hits[1].t), 5 - 0.775796, 2e-3 * slope / 1e-3 + 2e-6) << slope;
  }
}

TEST(Lathe, InsideIsBetweenTheSmallestRadiusAndTheCurve) {
  const auto linear = make(Lathe{PlanarSpline::kLinear, {{.5, -1}, {1, 0}, {.25, 1}}});
  EXPECT_FALSE(linear->inside({0, 0, 0}));
  EXPECT_FALSE(linear->inside({.5, 0, 0}));
  EXPECT_TRUE(linear->inside({.3, .9, 0}));
  const auto bezier = make(Lathe{PlanarSpline::kBezier, {{.5, -1}, {1.5, -.5}, {1, .5}, {.25, 1}}});
  EXPECT_TRUE(bezier->inside({.5, 0, 0}));
  EXPECT_FALSE(bezier->inside({.2, 0, 0}));
}

Prism prism(PlanarSpline spline, double low, std::vector<dvec2> points, bool conic = false) {
  return {spline, conic, low, 1, std::move(points), false, false};
}

TEST(Prism, TracesEverySpline) {
  EXPECT_FRONT(prism(PlanarSpline::kQuadratic, 0, {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {0, -1}}), .25, .5, -0.9375,
               dvec3(0.447214, 0, -0.894427));
  EXPECT_FRONT(prism(PlanarSpline::kCubic, 0, {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}), .25, .5, -0.918206,
               dvec3(0.486477, 0, -0.873693));
  EXPECT_FRONT(
      prism(PlanarSpline::kBezier, 0, {{-1, 0}, {-1, -1}, {1, -1}, {1, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, 0}}), .25, .5,
      -0.728768, dvec3(-0.170617, 0, 0.985337));
  EXPECT_FRONT(prism(PlanarSpline::kLinear, .5, {{-1, -1}, {1, -1}, {.5, 1}, {-1, 1}, {-1, -1}}, true), .25, .75, -0.75,
               dvec3(0, -0.707107, -0.707107));
}

// The number of surfaces that a ray crosses is even, through corners and along sides too; of two prisms that share a side, a ray in
// that side meets one.
TEST(Prism, RaysThroughCornersCrossTheOutlineAnEvenNumberOfTimes) {
  const auto crossings = [](const Shape& shape, const dvec3& from, const dvec3& to) {
    ShapeHits hits;
    shape.hits({from, glm::normalize(to - from)}, {1e-4, 1e6}, hits);
    return hits.size();
  };
  const auto left = make(prism(PlanarSpline::kLinear, 0, {{-1, -1}, {.1, -1}, {.1, 1}, {-1, 1}, {-1, -1}}));
  const auto right = make(prism(PlanarSpline::kLinear, 0, {{.1, -1}, {2, -.9}, {2, .7}, {.1, 1}, {.1, -1}}));
  EXPECT_EQ(crossings(*left, {.1, .5, -5}, {.1, .5, 5}) + crossings(*right, {.1, .5, -5}, {.1, .5, 5}), 2u);

  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const dvec2 a(any(random), any(random)), b(any(random), any(random)), c(any(random), any(random));
    const auto triangle = make(prism(PlanarSpline::kLinear, 0, {a, b, c, a}));
    const dvec3 from(4 * any(random), .5, 4 * any(random));
    EXPECT_EQ(crossings(*triangle, from, {a.x, .5, a.y}) % 2, triangle->inside(from) ? 1u : 0u) << i;
  }
}

TEST(Prism, ContainsItsBaseButNotItsTop) {
  const auto shape = make(prism(PlanarSpline::kLinear, 0, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}));
  EXPECT_TRUE(shape->inside({0, 0, 0}));
  EXPECT_FALSE(shape->inside({0, 1, 0}));
}

// Points against a polygon of many sides, by the even-odd rule; not those so near the outline that the polygon leaves it.
class PrismOfCurves : public testing::TestWithParam<PlanarSpline> {};

TEST_P(PrismOfCurves, ContainsWhatAFinePolygonDoes) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1, 1);
  int inside = 0;
  for (int turn = 0; turn < 30; ++turn) {
    std::vector<dvec2> p;
    for (int i = 0; i < 9; ++i) p.push_back({any(random), any(random)});
    // Loops of themselves: closed as each spline wants it.
    if (GetParam() == PlanarSpline::kBezier) p = {p[0], p[1], p[2], p[3], p[3], p[4], p[5], p[6], p[6], p[7], p[8], p[0]};
    else p.push_back(p[1]);
    if (GetParam() == PlanarSpline::kCubic) p.push_back(p[2]);
    const Prism outline = prism(GetParam(), 0, p);
    const auto shape = make(outline);
    std::vector<std::pair<dvec2, dvec2>> sides;
    constexpr int kSides = 300;
    for (const PlanarSegment& curve : prism_outline(outline).segments)
      for (int i = 0; i < kSides; ++i) sides.push_back({curve.at(i / double(kSides)), curve.at((i + 1) / double(kSides))});
    ASSERT_FALSE(sides.empty());
    for (int i = 0; i < 200; ++i) {
      const dvec2 q(any(random), any(random));
      bool odd = false, near = false;
      for (const auto& [a, b] : sides) {
        near = near || glm::length(q - a) < 1e-3 + glm::length(b - a);
        if ((a.y > q.y) != (b.y > q.y)) odd ^= a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x) > q.x;
      }
      if (near) continue;
      EXPECT_EQ(shape->inside({q.x, .5, q.y}), odd) << turn << ' ' << q.x << ' ' << q.y;
      inside += odd;
    }
  }
  EXPECT_GT(inside, 500);
}

INSTANTIATE_TEST_SUITE_P(Splines, PrismOfCurves, testing::Values(PlanarSpline::kQuadratic, PlanarSpline::kCubic, PlanarSpline::kBezier));

// Check case 19.
TEST(Prism, SubCurvesAlternate) {
  const auto shape = make(prism(PlanarSpline::kLinear, 0,
                                {{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}, {-1.5, -1.5}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}));
  EXPECT_TRUE(trace(*shape, {1.25, 5, .25}, {0, -1, 0}));
  EXPECT_FALSE(trace(*shape, {.75, 5, .25}, {0, -1, 0}));
}

TEST(Prism, UnclosedOutlines) {
  EXPECT_FALSE(prism_outline(prism(PlanarSpline::kLinear, 0, {{-1, -1}, {1, -1}, {1, 1}})).closed);
  EXPECT_EQ(prism_outline(prism(PlanarSpline::kLinear, 0, {{-1, -1}, {1, -1}, {1, 1}})).segments.size(), 3u);
  EXPECT_TRUE(prism_outline(prism(PlanarSpline::kCubic, 0, {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {1, 0}})).segments.empty());
}

SphereSweep sweep(SphereSweep::Spline spline) {
  return {spline, {{{-2, 0, 0}, .3}, {{-1, 0, 0}, .5}, {{1, .5, 0}, .25}, {{2, 0, 0}, .3}}, 1e-6};
}

TEST(SphereSweep, TracesEverySpline) {
  EXPECT_FRONT((SphereSweep{SphereSweep::Spline::kLinear, {{{-1, 0, 0}, .5}, {{1, 0, 0}, .25}}, 1e-6}), .1, .1, -0.351414,
               dvec3(0.125, 0.271552, -0.954272));
  EXPECT_FRONT(sweep(SphereSweep::Spline::kCubic), .1, .2, -0.362485, dvec3(0.221550, -0.224953, -0.948848));
  EXPECT_FRONT(sweep(SphereSweep::Spline::kBSpline), .1, .2, -0.360825, dvec3(0.114103, -0.135894, -0.984131));
}

TEST(SphereSweep, WithinAllSpheresIsOutside) {
  const auto shape = make(SphereSweep{SphereSweep::Spline::kLinear, {{dvec3(0), 1}, {{.1, 0, 0}, 1}}, 1e-6});
  EXPECT_FALSE(shape->inside({.05, 0, 0}));
  EXPECT_TRUE(shape->inside({1.05, 0, 0}));
}

TEST(Ovus, Traces) {
  EXPECT_FRONT((Ovus{1, .5}), .2, .5, -0.885370, dvec3(0.209307, 0.312500, -0.926571));
  EXPECT_FRONT((Ovus{.5, .9}), .1, .1, -0.8, dvec3(0.111111, -0.444444, -0.888889));
}

}  // namespace
}  // namespace lute
