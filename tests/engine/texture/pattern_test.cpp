#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/feature_points.hpp"
#include "pattern_value.hpp"

namespace lute {
namespace {

const dvec3 kP1{0.25, 0.5, 0.75}, kP2{-1.3, 2.7, 0.4}, kP3{17.1, -5.6, 33.3};

void expect_values(const PatternBody& body, double at1, double at2, double at3) {
  const auto at = [&](const dvec3& p) { return value_at(body, p); };
  EXPECT_NEAR(at(kP1), at1, 1e-11);
  EXPECT_NEAR(at(kP2), at2, 1e-11);
  EXPECT_NEAR(at(kP3), at3, 1e-11);
}

PatternBody with_turbulence(PatternBody body, const dvec3& amount) {
  ClassicTurbulence turbulence;
  turbulence.amount = amount;
  body.warps.push_back(turbulence);
  return body;
}

// Specification chapter 50 §16 A, measured with the reference.
TEST(Pattern, PlainPatternsEqualTheReference) {
  expect_values(body_of(Cells()), 0.711818915326, 0.208934925264, 0.175874419045);
  expect_values(body_of(Granite()), 0.421442084026, 0.567845282559, 0.272136268641);
  expect_values(body_of(Wrinkles()), 0.577164618752, 0.694731247059, 0.416150564671);
  expect_values(body_of(Dents()), 0.172418341215, 0.355874545353, 0.044954661360);
  expect_values(body_of(Ripples()), 0.298197950539, 0.460766131565, 0.470739331723);
  expect_values(body_of(Waves()), 0.666863344562, 0.461440225607, 0.567477975777);
  expect_values(body_of(Leopard()), 0.220420314829, 0.002393165189, 0.039804289522);
  expect_values(body_of(Onion()), 0.935414346693, 0.023243291566, 0.850495373244);
  expect_values(body_of(Radial()), 0.801208191175, 0.547507580470, 0.825503086349);
  expect_values(body_of(Quilted()), 0.140460534255, 0.126439708911, 0.226592567181);
  expect_values(body_of(Hexagon()), 0, 2, 0);
}

TEST(Pattern, AgateEqualsTheReference) {
  expect_values(with_turbulence(body_of(Agate()), dvec3(0)), 0.977304189797, 0.995469903131, 0.073311781829);
}

TEST(Pattern, CrackleEqualsTheReference) {
  Crackle crackle;
  expect_values(body_of(crackle), 0.221593356113, 0.214955581327, 0.240678660839);
  crackle.solid = true;
  expect_values(body_of(crackle), 0.432515686947, 0.611443568902, 0.528068536685);
  crackle = Crackle();
  crackle.form = {1, 0, 0};
  crackle.metric = 1;
  expect_values(body_of(crackle), 0.918763288762, 0.912469723262, 0.584003549349);
  crackle = Crackle();
  crackle.metric = 3;
  crackle.offset = 0.2;
  expect_values(body_of(crackle), 0.187163247046, 0.188279709635, 0.157827547308);
}

TEST(Pattern, SpiralsEqualTheReference) {
  Spiral1 one;
  one.arms = 3;
  expect_values(body_of(one), 0.824756864201, 0.221728855189, 0.216014461429);
  Spiral2 two;
  two.arms = 3;
  expect_values(body_of(two), 0.586654249097, 0.456998459360, 0.455549015346);
}

TEST(Pattern, TurbulenceActsLastOrInsideTheFormula) {
  expect_values(with_turbulence(body_of(Marble()), dvec3(0.5)), 0.361672377861, 0.773514761687, 0.983931857852);
  expect_values(with_turbulence(body_of(Wood()), dvec3(0.1)), 0.393300934932, 0.290681979338, 0.107158611448);
  Gradient gradient;
  gradient.direction = {1, 0, 0};
  expect_values(with_turbulence(body_of(gradient), dvec3(1)), 0.344708737646, 0.034766250434, 0.866122787610);
}

TEST(Pattern, AgateTurbulenceActsTwice) {
  Agate agate;
  agate.turbulence = 0.5f;
  const PatternBody body = with_turbulence(body_of(agate), dvec3(0.2));
  EXPECT_NEAR(value_at(body, kP1), 0.421967207801, 1e-11);
  EXPECT_NEAR(value_at(body, kP2), 0.969902569209, 1e-11);
}

TEST(Pattern, FirstNoiseGeneratorMakesAnotherGranite) {
  PatternBody body = body_of(Granite());
  body.noise_generator = 1;
  expect_values(body, 0.480709718750, 0.574109405774, 0.269540631342);
}

// gradient x scale 2 turbulence 0.3 octaves 3 lambda 2.5 omega 0.4 rotate 30*y
TEST(Pattern, TransformationsComeBeforeClassicTurbulence) {
  Gradient gradient;
  gradient.direction = {1, 0, 0};
  PatternBody body = body_of(gradient);
  ClassicTurbulence turbulence;
  turbulence.amount = dvec3(0.3);
  turbulence.octaves = 3;
  turbulence.lambda = 2.5f;
  turbulence.omega = 0.4f;
  body.warps.push_back(turbulence);
  prepend_transform(body.warps, Transform::scale(dvec3(2)));
  prepend_transform(body.warps, Transform::rotate({0, 30, 0}));
  EXPECT_NEAR(value_at(body, kP1), 0.867310822254, 1e-11);
  EXPECT_NEAR(value_at(body, kP2), 0.325323507209, 1e-11);
}

TEST(Pattern, ScaledSpottedOfGeneratorThree) {
  PatternBody body = body_of(Spotted());
  body.noise_generator = 3;
  prepend_transform(body.warps, Transform::scale(dvec3(0.3)));
  EXPECT_NEAR(value_at(body, kP1), 0.487840413723, 1e-11);
  EXPECT_NEAR(value_at(body, kP2), 0.325874023452, 1e-11);
}

TEST(Pattern, FrequencyMultipliesRadial) {
  PatternBody body = body_of(Radial());
  body.frequency = 6;
  EXPECT_NEAR(value_at(body, kP1), 0.807209147049, 1e-11);
  EXPECT_NEAR(value_at(body, kP2), 0.285015482818, 1e-11);
}

// Specification chapter 50 §16 B.
TEST(Pattern, FractalsEqualTheReference) {
  Mandel mandel;
  mandel.iterations = 25;
  EXPECT_NEAR(value_at(body_of(mandel), {0.5, 0.5, 0}), 0.12, 1e-11);
  EXPECT_NEAR(value_at(body_of(mandel), {-0.75, 0.3, 0}), 0.36, 1e-11);
  EXPECT_NEAR(value_at(body_of(mandel), {0.1, 0.1, 0}), 1, 1e-11);
  Julia julia;
  julia.c = {0.353, 0.288};
  julia.iterations = 30;
  julia.exponent = 3;
  julia.exterior_type = 6;
  julia.exterior_factor = 0.1;
  EXPECT_NEAR(value_at(body_of(julia), {0.9, 0.9, 0}), 0.206628676616, 1e-11);
  Magnet magnet;
  magnet.type = 2;
  magnet.julia = dvec2(0.2, 0.3);
  magnet.iterations = 20;
  magnet.interior_type = 6;
  magnet.interior_factor = 0.5;
  EXPECT_NEAR(value_at(body_of(magnet), {0.3, 0.4, 0}), 0.310569642390, 1e-11);
}

// At the border of a fractal the last bit decides. Printed by the reference with 20 digits.
TEST(Pattern, FractalsEqualTheReferenceToTheLastBit) {
  const auto expect_bits = [](auto fractal, double factor, const double (&expected)[3]) {
    fractal.iterations = 30;
    fractal.exterior_type = 6;
    fractal.exterior_factor = factor;
    fractal.interior_type = 1;
    fractal.interior_factor = 1;
    PatternBody body = body_of(fractal);
    body.frequency = 0;
    const dvec3 places[3] = {{0.9, 0.4, 0}, {-0.7, 0.8, 0}, {0.3, -1.1, 0}};
    for (int i = 0; i < 3; ++i) EXPECT_EQ(value_at(body, places[i]), expected[i]) << i;
  };
  Julia julia;
  julia.c = {-0.2, 0.6};
  julia.exponent = 3;
  expect_bits(julia, 0.1, {0.29166532222595037416, 0.36681245255221439638, 0.20646065000382038401});
  julia.exponent = 4;
  expect_bits(julia, 0.1, {0.62823148191537503404, 0.82771180078371608957, 0.21685617353444200384});
  Magnet magnet;
  magnet.julia = dvec2(0.2, 0.3);
  magnet.type = 1;
  expect_bits(magnet, 1e-5, {0.40918269575771271107, 0.11371119133574005000, 0.26908006193078998214});
  magnet.type = 2;
  expect_bits(magnet, 1e-5, {9.995408576940282622505692e-6, 0.16851932813390330113, 0.57269842345085131274});
}

TEST(Pattern, QuiltedControlsAndNegativeIntegers) {
  Quilted quilted;
  quilted.control0 = 0.2f;
  quilted.control1 = 0.7f;
  EXPECT_NEAR(value_at(body_of(quilted), kP1), 0.058222877461, 1e-11);
  EXPECT_NEAR(value_at(body_of(quilted), {-1, 0.5, 0.75}), 0.152799728741, 1e-11);
}

TEST(Pattern, ListPatternsAtChosenPoints) {
  EXPECT_EQ(value_at(body_of(Hexagon()), {0.9, 0, 0.3}), 2);
  EXPECT_EQ(value_at(body_of(Hexagon()), {-2.2, 0, -1.1}), 1);
  EXPECT_EQ(value_at(body_of(Cubic()), {-1, 0.2, 0.9}), 3);
}

// POV-Ray's pictures with exterior -1, 300 and -3 are those with 255, 44 and 253, that is 0, 2 and 1.
TEST(Pattern, PavementKindsAreBytesWithoutSign) {
  const auto value = [](int exterior, const dvec3& p) {
    Pavement pavement;
    pavement.tiles = 3;
    pavement.exterior = exterior;
    return value_at(body_of(pavement), p);
  };
  int differing = 0;
  for (int i = 0; i < 200; ++i) {
    const dvec3 p{0.037 * i, 0, 0.071 * i};
    EXPECT_EQ(value(-1, p), value(0, p));
    EXPECT_EQ(value(300, p), value(2, p));
    EXPECT_EQ(value(-3, p), value(1, p));
    differing += value(0, p) != value(1, p) && value(1, p) != value(2, p);
  }
  EXPECT_GT(differing, 0);
}

TEST(Pattern, WavesShapeTheValue) {
  Gradient gradient;
  gradient.direction = {1, 0, 0};
  PatternBody body = body_of(gradient);
  body.wave = Wave::kSine;
  EXPECT_NEAR(value_at(body, {0.3, 0, 0}), 0.975528258148, 1e-11);
  EXPECT_NEAR(value_at(body, {-0.3, 0, 0}), 0.024471741852, 1e-11);
  body.wave = Wave::kPoly;
  body.wave_exponent = 3;
  EXPECT_NEAR(value_at(body, {0.3, 0, 0}), 0.027, 1e-11);
}

// Measured with the reference: without size all is mortar, by comparisons with infinity and NaN.
TEST(Pattern, BricksWithoutSizeAreMortar) {
  Brick brick;
  for (const dvec3& size : {dvec3(0), dvec3(1, 0, 1)}) {
    brick.size = size;
    for (const dvec3& p : {kP1, kP2, kP3, dvec3(0)}) EXPECT_EQ(value_at(body_of(brick), p), 0);
  }
}

// Chapter 50 §6.7: no surface, no slope and no angle of incidence.
TEST(Pattern, SlopeAndAoiNeedASurface) {
  EXPECT_EQ(value_at(body_of(Slope()), kP1), 0);
  EXPECT_EQ(value_at(body_of(Aoi()), kP1), 0);
  SurfaceContext surface;
  surface.has_surface = true;
  surface.normal = {0, 1, 0};
  surface.ray_direction = {0, -1, 0};
  EXPECT_NEAR(value_at(body_of(Aoi()), kP1, surface), 1, 1e-11);
  EXPECT_NEAR(value_at(body_of(Slope()), kP1, surface), 1 - 1e-10, 1e-14);
  surface.normal = {1, 0, 0};
  EXPECT_NEAR(value_at(body_of(Slope()), kP1, surface), 0.5, 1e-11);
}

// The nearest feature points are the same whether cubes are passed over or not: against a plain search of all 81.
TEST(Pattern, CracklePassesOverNoCubeThatCounts) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  for (const double metric : {1.0, 2.0, 3.0, 0.5})
    for (int i = 0; i < 2000; ++i) {
      // Far apart, then in a few cubes, whose points are remembered.
      const double reach = i < 1000 ? 30 : 1.5;
      const dvec3 p = reach * dvec3(place(random), place(random), place(random));
      const FeaturePoints n = crackle_points(p, metric, 3);
      const dvec3 alone = crackle_distances(p, metric, 3);
      const double first = crackle_distances(p, metric, 1)[0], second = crackle_distances(p, metric, 2)[1];
      std::vector<double> all;
      const dvec3 f(std::floor(p.x - kEpsilon), std::floor(p.y - kEpsilon), std::floor(p.z - kEpsilon));
      for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
          for (int z = -2; z <= 2; ++z) {
            if ((x * x == 4) + (y * y == 4) + (z * z == 4) > 1) continue;
            const dvec3 c = f + dvec3(x, y, z);
            const std::uint32_t h = hash3(std::lround(c.x), std::lround(c.y), std::lround(c.z));
            const dvec3 d = p - (c + dvec3(random_table(h), random_table(h + 1), random_table(h + 2)));
            all.push_back(std::pow(std::fabs(d.x), metric) + std::pow(std::fabs(d.y), metric) + std::pow(std::fabs(d.z), metric));
          }
      std::sort(all.begin(), all.end());
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(n.distance[k], all[k], 1e-9);
      // The same to the last bit, remembered or not.
      for (int k = 0; k < 3; ++k) EXPECT_EQ(alone[k], n.distance[k]);
      EXPECT_EQ(first, n.distance[0]);
      EXPECT_EQ(second, n.distance[1]);
    }
}

}  // namespace
}  // namespace lute
