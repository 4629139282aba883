#include <gtest/gtest.h>

#include "engine/texture/texture_compiler.hpp"

namespace lute {
namespace {

const dvec3 kP1{0.25, 0.5, 0.75}, kP2{-1.3, 2.7, 0.4}, kP3{17.1, -5.6, 33.3};

template <class Pattern>
PatternBody body_of(const Pattern& pattern) {
  PatternBody body;
  body.pattern = AnyPattern(pattern);
  body.frequency = Pattern::kFrequency;
  body.wave = Pattern::kWave;
  return body;
}

void expect_values(const PatternBody& body, double at1, double at2, double at3) {
  TextureCompiler compiler{TextureSettings()};
  const CompiledPattern pattern(body, compiler);
  const auto at = [&](const dvec3& p) { return pattern.value(pattern.warp(p), SurfaceContext()); };
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

}  // namespace
}  // namespace lute
