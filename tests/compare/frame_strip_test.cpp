// Sets of frames: an INI file with a range of frames is compared frame by frame.
#include "compare/frame_strip.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "compare/batch.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

Picture grey_frames(const std::vector<float>& values) {
  Picture strip(2, 2 * static_cast<int>(values.size()));
  for (int y = 0; y < strip.height; ++y)
    for (int x = 0; x < strip.width; ++x)
      for (int c = 0; c < 4; ++c) strip.at(x, y)[c] = c == 3 ? 1 : values[static_cast<std::size_t>(y) / 2];
  return strip;
}

const FrameNoise kNone = [](int) { return std::optional<ReferenceNoise>(); };

TEST(WorstFrame, IsTheOneFarthestApart) {
  const WorstFrame worst = worst_frame(grey_frames({.5f, .2f, .1f}), grey_frames({.5f, .4f, .2f}), 2, kNone);
  EXPECT_EQ(worst.count, 3);
  EXPECT_EQ(worst.index, 1);
  EXPECT_NEAR(worst.difference.maximum, .2, 1e-6);
  EXPECT_EQ(worst.a.height, 2);
}

TEST(WorstFrame, CountsAMissingFrameAsWhollyDifferent) {
  const WorstFrame worst = worst_frame(grey_frames({.5f, .5f}), grey_frames({.5f, .4f, .5f}), 2, kNone);
  EXPECT_EQ(worst.count, 3);
  EXPECT_EQ(worst.index, 2);
  EXPECT_EQ(worst.difference.within, 0);
}

TEST(WorstFrame, AllowsEachFrameItsOwnNoise) {
  const FrameNoise second = [](int frame) {
    return frame == 1 ? std::optional<ReferenceNoise>({.within = 0, .rmse = 0.3, .block98_255 = 60}) : std::nullopt;
  };
  const WorstFrame noisy = worst_frame(grey_frames({.5f, .2f}), grey_frames({.5f, .4f}), 2, second);
  EXPECT_EQ(noisy.index, 1);
  EXPECT_TRUE(matches(noisy.difference, noisy.noise));
  // The same noise in a frame that has none.
  const WorstFrame plain = worst_frame(grey_frames({.3f, .2f}), grey_frames({.5f, .4f}), 2, second);
  EXPECT_EQ(plain.index, 0);
  EXPECT_FALSE(matches(plain.difference, plain.noise));
}

TEST(FrameSet, IsAnIniFileThatNamesAScene) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "set.ini") << "Antialias=On\ninput_file_name = ball.pov ; the scene\nFinal_Frame=3\n";
  std::ofstream(folder.path() / "defaults.ini") << "Antialias=On\n; Input_File_Name=ball.pov\n";
  std::ofstream(folder.path() / "ball.pov") << "sphere { 0, 1 }";
  EXPECT_EQ(scene_of_set(folder.path() / "set.ini"), folder.path() / "ball.pov");
  EXPECT_FALSE(scene_of_set(folder.path() / "defaults.ini"));
  const std::vector<SceneFile> scenes = find_scenes({folder.path().string()});
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[0].name, "ball.pov");
  EXPECT_EQ(scenes[1].name, "set.ini");
}

// The reference in both places, and a scene that tells its frames apart.
TEST(FrameSet, EveryFrameIsRenderedAndCompared) {
  const ScratchFolder scenes, cache, output;
  std::ofstream(scenes.path() / "set.ini") << "Input_File_Name=fade.pov\nInitial_Frame=1\nFinal_Frame=10\n";
  std::ofstream(scenes.path() / "fade.pov") << "#version 3.7; global_settings { assumed_gamma 1 } background { rgb frame_number / 10 }";
  ComparisonSettings settings;
  settings.lute_program = "povray";
  settings.output = output.path();
  settings.lute.width = settings.reference.width = 16;
  settings.lute.height = settings.reference.height = 12;
  const ReferenceCache reference(cache.path(), "povray");
  const SceneComparison result = compare_scene({scenes.path() / "set.ini", "set.ini"}, reference, {}, settings);
  EXPECT_EQ(result.state, SceneState::kMatch);
  EXPECT_EQ(result.frames, 10);
  // Half the size, ten frames under each other, from dark to light.
  const Picture strip = read_picture(output.path() / "set.ini.lute.png");
  EXPECT_EQ(strip.width, 8);
  ASSERT_EQ(strip.height, 60);
  for (int frame = 1; frame < 10; ++frame) EXPECT_GT(strip.at(0, 6 * frame)[0], strip.at(0, 6 * (frame - 1))[0]);
}

}  // namespace
}  // namespace lute::compare
