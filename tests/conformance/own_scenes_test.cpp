// Every algorithm of the lecture has a scene in scenes/lecture, every feature one in scenes/feature; each must match POV-Ray's picture.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <ostream>

#include "compare/scene_comparison.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

// Shown by GoogleTest beside the name of the test.
void PrintTo(const SceneFile& scene, std::ostream* out) { *out << scene.name; }

namespace {

std::vector<SceneFile> scenes_of(const char* folder) { return find_scenes({std::string(LUTE_SOURCE_DIR "/scenes/") + folder}); }

// GoogleTest allows letters, digits and underscores.
std::string test_name(const testing::TestParamInfo<SceneFile>& test) {
  std::string name = std::filesystem::path(test.param.name).replace_extension().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

class OwnScene : public testing::TestWithParam<SceneFile> {};

TEST_P(OwnScene, MatchesTheReference) {
  const ReferenceCache cache(ReferenceCache::default_folder(), "povray");
  ComparisonSettings settings;
  settings.lute_program = LUTE_BINARY_DIR "/lute";
  settings.output = std::filesystem::path(LUTE_BINARY_DIR) / "../conformance-pictures" / GetParam().path.parent_path().filename();
  const SceneComparison comparison = compare_scene(GetParam(), cache, {}, settings);
  ASSERT_TRUE(comparison.difference) << name_of(comparison.state) << '\n' << comparison.lute.messages;
  EXPECT_EQ(comparison.state, SceneState::kMatch)
      << "within 2/255: " << comparison.difference->within << ", RMSE: " << comparison.difference->rmse
      << ", heat map: " << comparison.heat_map;
}

INSTANTIATE_TEST_SUITE_P(Lecture, OwnScene, testing::ValuesIn(scenes_of("lecture")), test_name);
INSTANTIATE_TEST_SUITE_P(Feature, OwnScene, testing::ValuesIn(scenes_of("feature")), test_name);

}  // namespace
}  // namespace lute::compare
