#include "compare/match.hpp"

#include <gtest/gtest.h>

namespace lute::compare {
namespace {

Difference figures(double within, double rmse, double block98) {
  Difference d;
  d.within = within;
  d.rmse = rmse;
  d.block98_255 = block98;
  return d;
}

TEST(Match, NeedsShareOfPixelsAndRmse) {
  EXPECT_TRUE(matches(figures(0.995, 0.01, 50)));
  EXPECT_FALSE(matches(figures(0.9949, 0.001, 0)));
  EXPECT_FALSE(matches(figures(0.999, 0.0101, 0)));
}

TEST(Match, NoisySceneMayDifferAsMuchAsTheReferenceFromItself) {
  const ReferenceNoise noise{0.75, 0.0142, 1.39};
  EXPECT_TRUE(matches(figures(0.7, 1.25 * 0.0142, 1.5 * 1.39), noise));
  EXPECT_FALSE(matches(figures(0.7, 1.26 * 0.0142, 1), noise));
  EXPECT_FALSE(matches(figures(0.7, 0.0142, 2.2), noise));
}

TEST(Match, NoiseHasFloors) {
  const ReferenceNoise noise{0.99, 0.001, 0.1};
  EXPECT_TRUE(matches(figures(0.9, 0.004, 2), noise));
  EXPECT_FALSE(matches(figures(0.9, 0.0041, 2), noise));
}

TEST(ReferenceNoiseTable, HoldsTheScenesThatDifferFromThemselves) {
  const ReferenceNoiseTable table(LUTE_REFERENCE_NOISE);
  EXPECT_EQ(table.size(), 70u);  // rows of reference-noise.csv
  ASSERT_TRUE(table.find("lights/orient.pov"));
  EXPECT_TRUE(table.find("portfolio/t_1stones.ini/52"));  // a frame of a set
  EXPECT_DOUBLE_EQ(table.find("lights/orient.pov")->rmse, 0.01423);
  EXPECT_FALSE(table.find("lights/nothing.pov"));
  EXPECT_TRUE(table.find("/some/where/examples/lights/orient.pov"));
  EXPECT_FALSE(table.find("orient.pov"));
  EXPECT_FALSE(table.find("spotlights/orient.pov"));
}

}  // namespace
}  // namespace lute::compare
