#include "compare/sample_counts.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace lute::compare {
namespace {

// As POV-Ray 3.7 prints it.
TEST(SampleCounts, OfPovRayAreThoseOfTheGridAndOfAntialiasing) {
  const auto samples = samples_in(
      "Render Statistics\nImage Resolution 160 x 120\n"
      "----------------------------------------------------------------------------\n"
      "Pixels:            19481   Samples:           13338   Smpls/Pxl: 0.68\n"
      "Rays:              40000   Saved:                 0   Max Level: 2/5\n");
  EXPECT_EQ(samples, 32819);
}

TEST(SampleCounts, OfLuteAreItsCameraRays) {
  EXPECT_EQ(samples_in("rays\n  camera                      32819        1.71 a pixel\n  reflected   7   0.00 a pixel\n"), 32819);
}

TEST(SampleCounts, AreMissingWithoutStatistics) { EXPECT_EQ(samples_in("Parse error\n"), std::nullopt); }

TEST(SampleCounts, PassWithinTwoPercentIfThePicturesMatch) {
  const SampleCount near{"a.pov", "+A0.3", 2, 2.039, 1, true}, far{"a.pov", "+A0.3", 2, 1.959, 1, true},
      other{"a.pov", "+A0.3", 2, 2, 0.9, false};
  EXPECT_TRUE(near.passes());
  EXPECT_FALSE(far.passes());
  EXPECT_FALSE(other.passes());
  std::ostringstream page;
  write_markdown(page, {near, far, other}, "A machine.");
  EXPECT_NE(page.str().find("1 of 3 pictures match"), std::string::npos);
  EXPECT_NE(page.str().find("| a.pov | `+A0.3` | 2.0000 | 2.0390 | +1.95 % | 100.00 % |"), std::string::npos);
}

}  // namespace
}  // namespace lute::compare
