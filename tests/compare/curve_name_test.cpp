// What lute and POV-Ray make of antialiasing switches: `lute scene.pov SWITCHES --stats` tells from its samples which method it took.
#include "compare/curve_name.hpp"

#include <gtest/gtest.h>

namespace lute::compare {
namespace {

TEST(CurveName, NamesTheMethodOfTheSwitches) {
  EXPECT_EQ(method_of(""), "no antialiasing");
  EXPECT_EQ(method_of("-A"), "no antialiasing");
  EXPECT_EQ(method_of("+A0.3"), "method 1");
  EXPECT_EQ(method_of("+a0.3"), "method 1");
  EXPECT_EQ(method_of("+AM2 +A0.1 +R3"), "method 2");
  EXPECT_EQ(method_of("+AM2"), "no antialiasing");
  EXPECT_EQ(method_of("+AM3"), "method 3");
  EXPECT_EQ(method_of("-A +AM3 +AE0.01"), "method 3");
  EXPECT_EQ(method_of("+AG2.2 +AE0.1"), "no antialiasing");
}

TEST(CurveName, LaterSwitchesWin) {
  EXPECT_EQ(method_of("+A0.3 -A"), "no antialiasing");
  EXPECT_EQ(method_of("+AM3 -A"), "no antialiasing");
  EXPECT_EQ(method_of("-A +A0.3 +AM2"), "method 2");
}

TEST(CurveName, KnowsTheLongForms) {
  EXPECT_EQ(method_of("Sampling_Method=3"), "method 3");
  EXPECT_EQ(method_of("--sampling-method=2 --antialias"), "method 2");
  EXPECT_EQ(method_of("Antialias=on Antialias_Threshold=0.1"), "method 1");
  EXPECT_EQ(method_of("+A0.3 --no-antialias"), "no antialiasing");
  EXPECT_EQ(method_of("+A0.3 Antialias=off"), "no antialiasing");
}

TEST(CurveName, NamesWhatVaries) {
  EXPECT_EQ(curve_of("+AM2 +A0.1 +R3 +J"), "method 2");
  EXPECT_EQ(curve_of("+A0.1 Declare=Accuracy=0.01"), "method 1, Accuracy");
  EXPECT_EQ(curve_of("-A Declare=Accuracy=1e-5 Declare=Sturm=1"), "no antialiasing, Accuracy, Sturm");
  EXPECT_EQ(curve_of("+Q5"), "no antialiasing, quality");
}

}  // namespace
}  // namespace lute::compare
