// A sweep as it runs the two programs: in what order, how often, and what it makes of their pictures. Shell scripts stand in for
// the programs; they note what they are asked for and copy pictures that the tests have made.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "compare/content_hash.hpp"
#include "compare/scratch_folder.hpp"
#include "compare/sweep.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 2, kHeight = 1, kAcross = 16;

class SweepRun : public testing::Test {
 protected:
  SweepRun() {
    // Apart from what the programs write: the cache looks at all that lies beside a scene.
    fs::create_directories(scene().path.parent_path());
    std::ofstream(scene().path) << "sphere { 0, 1 }\n";
    settings_.width = kWidth;
    settings_.height = kHeight;
    settings_.lute_program = program("lute", "lute 1", "own.png");
    settings_.reference_program = program("reference", "POV-Ray 3", "reference.png");
    settings_.output = folder_.path() / "output";
    fs::create_directories(settings_.output);
    write_picture(filled(kWidth * kAcross, kHeight * kAcross, 0.2f), folder_.path() / "large.exr");
    for (const char* name : {"own.png", "reference.png"}) write_picture(filled(kWidth, kHeight, 0.5f), folder_.path() / name);
  }

  static Picture filled(int width, int height, float value) {
    Picture picture(width, height);
    for (float& v : picture.values) v = value;
    return picture;
  }

  // Writes down "NAME SWITCHES" as often as it renders; `before` is done first, with $switches and $calls, the number of calls so far.
  std::string program(const std::string& name, const std::string& version, const std::string& picture, const std::string& before = "") {
    const std::string at = folder_.path().string() + "/";
    const fs::path script = at + name;
    std::ofstream(script) << "#!/bin/sh\n"
                             "if [ \"$1\" = --version ]; then echo '" << version << "'; exit; fi\n"
                             "source=" << at << picture << "\nswitches=\n"
                             "for word; do case $word in\n"
                             "  +O*) target=${word#+O} ;; +FE) source=" << at << "large.exr; switches=\"$switches $word\" ;;\n"
                             "  +A*|Declare=*) switches=\"$switches $word\" ;;\n"
                             "esac; done\n"
                             "calls=$(grep -c '^" << name << "' " << at << "calls 2>/dev/null)\n"
                             "echo '" << name << "'\"$switches\" >>" << at << "calls\n"
                          << before << "\ncp $source $target\n";
    fs::permissions(script, fs::perms::owner_all);
    return script.string();
  }

  std::string calls() const { return fs::exists(folder_.path() / "calls") ? read_file(folder_.path() / "calls") : ""; }
  SceneFile scene() const { return {folder_.path() / "scene" / "a.pov", "a.pov"}; }
  fs::path cache() const { return folder_.path() / "cache"; }
  Picture converged() const { return converged_picture(scene(), settings_, cache()); }
  Sweep sweep() const { return run_sweep(scene(), settings_, cache()); }

  const ScratchFolder folder_;
  SweepSettings settings_;
};

// Light of 0, 1, 0, 1 … in the left pixel, and of 2 in a quarter of the right one: means of a half, which sRGB codes as 0.73536
// (IEC 61966-2-1). Coded before the mean, the left one would be 0.5; clamped before it, the right one would be 0.537.
TEST_F(SweepRun, ConvergedPictureIsTheMeanOfLightBeforeClamping) {
  Picture large(kWidth * kAcross, kHeight * kAcross);
  for (int y = 0; y < kAcross; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      for (int c = 0; c < 3; ++c) {
        large.at(x, y)[c] = static_cast<float>((x + y) % 2);
        large.at(kAcross + x, y)[c] = x < kAcross / 2 && y < kAcross / 2 ? 2.0f : 0.0f;
      }
    }
  }
  write_picture(large, folder_.path() / "large.exr");
  const Picture picture = converged();
  ASSERT_EQ(picture.width, kWidth);
  ASSERT_EQ(picture.height, kHeight);
  for (int x = 0; x < kWidth; ++x) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(x, 0)[c], 0.73536, 1e-5) << x << " " << c;
  }
}

TEST_F(SweepRun, ConvergedPictureIsMadeOnceForEachSceneAndSize) {
  converged();
  converged();
  EXPECT_EQ(calls(), "reference +FE\n");
  std::ofstream(scene().path) << "sphere { 0, 2 }\n";
  converged();
  EXPECT_EQ(calls(), "reference +FE\nreference +FE\n");
}

TEST_F(SweepRun, SceneThatTheReferenceRefusesHasNoConvergedPicture) {
  settings_.reference_program = program("reference", "POV-Ray 3", "reference.png", "exit 1");
  try {
    converged();
    FAIL() << "it has one";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.pov: rejected"), std::string::npos) << error.what();
  }
  EXPECT_THROW(sweep(), std::runtime_error);
}

TEST_F(SweepRun, ProgramsTakeTurnsAndMethodThreeIsOursAlone) {
  settings_.variations = {"+A0.3", "+AM3 +AE0.01"};
  settings_.runs = 2;
  sweep();
  const std::string turn = "lute +A0.3\nreference +A0.3\nlute +AM3 +AE0.01\n";
  EXPECT_EQ(calls(), "reference +FE\n" + turn + turn);
}

// Against a converged picture of light 0.2, coded 0.48453: 0.5 is stored as 128/255, off by 0.01743; 0.48453 as 124/255, off by 0.00174.
TEST_F(SweepRun, ErrorsAreMeasuredAgainstTheConvergedPicture) {
  write_picture(filled(kWidth, kHeight, 0.48453f), folder_.path() / "own.png");
  settings_.variations = {"+A0.3"};
  settings_.runs = 1;
  const Sweep done = sweep();
  ASSERT_EQ(done.points.size(), 2u);
  const SweepPoint &own = done.points[0], &theirs = done.points[1];
  EXPECT_EQ(own.program, "lute");
  EXPECT_EQ(own.method, "method 1");
  EXPECT_NEAR(own.rmse, 0.00174, 2e-5);
  EXPECT_EQ(own.within, 1);
  EXPECT_NEAR(theirs.rmse, 0.01743, 2e-5);
  EXPECT_EQ(theirs.within, 0);
  for (const SweepPoint& point : done.points) {
    EXPECT_EQ(read_picture(point.picture).width, kWidth);
    EXPECT_EQ(read_picture(point.heat_map).width, kWidth);
  }
  EXPECT_NEAR(read_picture(done.converged).at(0, 0)[0], 0.4845, 0.002);
}

// The first run takes two seconds: with it the mean of three is above 0.66 s.
TEST_F(SweepRun, MedianTimeCounts) {
  settings_.lute_program = program("lute", "lute 1", "own.png", "[ $calls != 0 ] || sleep 2");
  settings_.variations = {"+A0.3"};
  settings_.runs = 3;
  const Sweep done = sweep();
  EXPECT_GT(done.points[0].wall, 0);
  EXPECT_LT(done.points[0].wall, 0.66);
}

TEST_F(SweepRun, PointThatFailsSaysWhyAndIsNotTriedAgain) {
  settings_.lute_program = program("lute", "lute 1", "own.png", "echo first >&2; echo 'no such switch' >&2; echo >&2; exit 2");
  settings_.variations = {"+A0.3"};
  settings_.runs = 3;
  const Sweep done = sweep();
  EXPECT_FALSE(done.points[0].rendered);
  EXPECT_EQ(done.points[0].failure, "rejected: no such switch");
  EXPECT_FALSE(done.points[0].pareto);
  EXPECT_TRUE(done.points[1].rendered);
  EXPECT_TRUE(done.points[1].pareto);
  const std::string made = calls();
  EXPECT_EQ(made.find("lute", made.find("lute") + 1), std::string::npos) << made;
}

TEST_F(SweepRun, PointBeyondTheTimeLimitFails) {
  settings_.lute_program = program("lute", "lute 1", "own.png", "sleep 30");
  settings_.variations = {"+A0.3"};
  settings_.runs = 1;
  settings_.time_limit = 0.5;
  const Sweep done = sweep();
  EXPECT_EQ(done.points[0].failure, "timeout");
}

}  // namespace
}  // namespace lute::compare
