#include "compare/scene_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lute::compare {
namespace {

std::vector<SceneFile> numbered_scenes(int count) {
  std::vector<SceneFile> scenes;
  for (int i = 0; i < count; ++i) scenes.push_back({"", "folder/scene" + std::to_string(i) + ".pov"});
  return scenes;
}

std::vector<std::string> names_of(const std::vector<SceneFile>& scenes) {
  std::vector<std::string> names;
  for (const SceneFile& scene : scenes) names.push_back(scene.name);
  return names;
}

TEST(SampleScenes, TakesAboutTheAskedShare) {
  EXPECT_EQ(sample_scenes(numbered_scenes(6000), 1).size(), 6000u);
  // Binomial with p = 1/6: 1000 +- 29; four deviations.
  EXPECT_NEAR(static_cast<double>(sample_scenes(numbered_scenes(6000), 6).size()), 1000.0, 116.0);
}

TEST(SampleScenes, NewScenesDoNotChangeWhoIsIn) {
  const std::vector<std::string> few = names_of(sample_scenes(numbered_scenes(500), 6));
  const std::vector<std::string> many = names_of(sample_scenes(numbered_scenes(1000), 6));
  EXPECT_FALSE(few.empty());
  for (const std::string& name : few) EXPECT_NE(std::find(many.begin(), many.end(), name), many.end()) << name;
}

}  // namespace
}  // namespace lute::compare
