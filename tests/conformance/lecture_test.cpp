// Every algorithm of the lecture has a scene in scenes/lecture; each must match POV-Ray's picture.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "compare/scene_comparison.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

// Shown by GoogleTest beside the name of the test.
void PrintTo(const SceneFile& scene, std::ostream* out) { *out << scene.name; }

namespace {

std::vector<SceneFile> lecture_scenes() { return find_scenes({LUTE_SOURCE_DIR "/scenes/lecture"}); }

class LectureScene : public testing::TestWithParam<SceneFile> {};

TEST_P(LectureScene, MatchesTheReference) {
  const ReferenceCache cache(ReferenceCache::default_folder(), "povray");
  ComparisonSettings settings;
  settings.lute_program = LUTE_BINARY_DIR "/lute";
  settings.output = std::filesystem::path(LUTE_BINARY_DIR) / "../lecture-pictures";
  const SceneComparison comparison = compare_scene(GetParam(), cache, {}, settings);
  ASSERT_TRUE(comparison.difference) << name_of(comparison.state) << '\n' << comparison.lute.messages;
  EXPECT_EQ(comparison.state, SceneState::kMatch)
      << "within 2/255: " << comparison.difference->within << ", RMSE: " << comparison.difference->rmse
      << ", heat map: " << comparison.heat_map;
}

INSTANTIATE_TEST_SUITE_P(All, LectureScene, testing::ValuesIn(lecture_scenes()),
                         [](const auto& test) { return std::filesystem::path(test.param.name).stem().string(); });

}  // namespace
}  // namespace lute::compare
