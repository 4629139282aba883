// The noise of lute is that of POV-Ray: 22500 points of each generator; `lute-compare noise` compares a million.
#include "compare/noise_comparison.hpp"

#include <gtest/gtest.h>

namespace lute::compare {
namespace {

class Noise : public testing::TestWithParam<int> {};

TEST_P(Noise, IsThatOfTheReference) {
  const NoiseComparison c = compare_noise(GetParam(), 150, LUTE_BINARY_DIR "/lute", "povray");
  EXPECT_EQ(c.points, 22500u);
  EXPECT_LE(c.largest, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Generators, Noise, testing::Values(1, 2, 3));

}  // namespace
}  // namespace lute::compare
