#include "parser/options/frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lute {
namespace {

using testing::ElementsAre;

std::vector<int> numbers(const RenderOptions& options) {
  std::vector<int> all;
  for (const Frame& frame : frames_of(options)) all.push_back(frame.number);
  return all;
}

std::vector<double> clocks(const RenderOptions& options) {
  std::vector<double> all;
  for (const Frame& frame : frames_of(options)) all.push_back(frame.clock);
  return all;
}

RenderOptions animation(int last) {
  RenderOptions options;
  options.final_frame = last;
  return options;
}

// Chapter 30 §12 K.
TEST(Frames, ClockRunsFromZeroToOne) {
  EXPECT_THAT(numbers(animation(4)), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(frames_of(animation(4))[1].clock, 0.3333333432674407959);  // single precision
  EXPECT_EQ(frames_of(animation(4))[3].clock, 1.0);
}

TEST(Frames, CyclicLeavesTheLastOut) {
  RenderOptions options = animation(4);
  options.cyclic = true;
  EXPECT_THAT(clocks(options), ElementsAre(0, 0.25, 0.5, 0.75));
  EXPECT_EQ(frames_of(options)[0].values.final_frame, 5);
}

TEST(Frames, SubsetsByFraction) {
  RenderOptions options = animation(8);
  options.subset_start = 0.5;
  options.subset_end = 0.9;
  EXPECT_THAT(numbers(options), ElementsAre(4, 5, 6, 7));
}

// POV-Ray renders frames 1...9 with +KFI1 +KFF5 +SF0 +EF9.
TEST(Frames, SubsetEndsBeyondTheLastFrame) {
  RenderOptions options = animation(5);
  options.subset_start = 0;
  options.subset_end = 9;
  EXPECT_THAT(numbers(options), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
}

TEST(Frames, Steps) {
  RenderOptions options = animation(7);
  options.frame_step = 3;
  EXPECT_THAT(numbers(options), ElementsAre(1, 4, 7));
}

TEST(Frames, OwnClockRange) {
  RenderOptions options = animation(4);
  options.initial_frame = 3;
  options.initial_clock = 10;
  options.final_clock = 20;
  EXPECT_THAT(clocks(options), ElementsAre(10, 20));
}

TEST(Frames, OneFrameAloneIsAnAnimationOnlyWithoutAFirst) {
  EXPECT_FALSE(is_animated(RenderOptions{}));
  EXPECT_FALSE(is_animated(animation(0)));
  RenderOptions still = animation(1);
  still.initial_frame = 1;
  EXPECT_FALSE(is_animated(still));
  const std::vector<Frame> frames = frames_of(animation(1));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_TRUE(std::isinf(frames[0].values.clock_delta));
}

std::string path(RenderOptions options, const std::string& output, int frame = 0) {
  options.output_file = output;
  if (options.input_file.empty()) options.input_file = "scenes/s.pov";
  Frame one;
  one.number = frame;
  return output_path(options, one);
}

TEST(OutputPath, ComesFromTheInput) {
  EXPECT_EQ(path({}, ""), "scenes/s.png");
  EXPECT_EQ(path({}, "out/"), "out/s.png");
  EXPECT_EQ(path({}, ".png"), "scenes/s.png");
}

TEST(OutputPath, GetsTheExtensionOfTheFormat) {
  EXPECT_EQ(path({}, "foo"), "foo.png");
  EXPECT_EQ(path({}, "foo.png"), "foo.png");
  EXPECT_EQ(path({}, "foo."), "foo.png");
  EXPECT_EQ(path({}, "foo.tga"), "foo.tga.png");
  RenderOptions targa;
  targa.output.format = FileFormat::kTarga;
  EXPECT_EQ(path(targa, "foo.tga"), "foo.tga");
}

TEST(OutputPath, DashIsStandardOutput) { EXPECT_EQ(path({}, "-"), "-"); }

// Chapter 30 §12 K.
TEST(OutputPath, CarriesTheFrameNumber) {
  EXPECT_EQ(path(animation(3), "", 2), "scenes/s2.png");
  EXPECT_EQ(path(animation(12), "", 1), "scenes/s01.png");
  EXPECT_EQ(path(animation(3), "foo.png", 1), "foo1.png");
  RenderOptions cyclic = animation(9);
  cyclic.cyclic = true;
  EXPECT_EQ(path(cyclic, "", 9), "scenes/s09.png");
}

// +EF goes beyond Final_Frame. POV-Ray keeps the length of the name: +Oanim +KFF9 +SF98 +EF101 writes ani98, ani99, an100,
// an101, and the folder's slash is lost in time (+Oout/b gives out100.png). A number must not cost the name its letters.
TEST(OutputPath, NumbersLongerThanFinalFrameLeaveTheNameWhole) {
  EXPECT_EQ(path(animation(9), "anim", 9), "anim9.png");
  EXPECT_EQ(path(animation(9), "anim", 10), "anim10.png");
  EXPECT_EQ(path(animation(9), "anim", 100), "anim100.png");
  EXPECT_EQ(path(animation(9), "out/b", 100), "out/b100.png");
  EXPECT_EQ(path(animation(12), "", 120), "scenes/s120.png");
}

}  // namespace
}  // namespace lute
