#include "compare/coverage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "compare/scratch_folder.hpp"

namespace lute::compare {
namespace {

using ::testing::HasSubstr;

std::string subject(const std::string& text) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "scene.pov") << text;
  return subject_of_scene(folder.path() / "scene.pov");
}

TEST(Coverage, SubjectIsTheFirstSentenceOfTheFirstComment) {
  EXPECT_EQ(subject("// torus: a ring\n// of two radii. More.\nsphere"), "torus: a ring of two radii");
  EXPECT_EQ(subject("// |x| grows.\n"), "\\|x\\| grows");
  EXPECT_EQ(subject("sphere { 0, 1 }\n// late\n"), "");
}

TEST(Coverage, CountsByFolder) {
  SceneComparison good, bad;
  good.scene.name = "feature/shape/torus.pov";
  good.state = SceneState::kMatch;
  good.difference.emplace();
  good.difference->within = 1;
  bad.scene.name = "feature/shape/sor.pov";
  bad.state = SceneState::kLuteError;
  StateTable examples;
  examples["media/fog.pov"] = {SceneState::kUnsupported, {}, {}, {}};
  examples["media/air.pov"] = {SceneState::kMatch, {}, {}, {}};
  examples["shapes/box.pov"] = {SceneState::kBothReject, {}, {}, {}};
  std::ostringstream page;
  write_coverage(page, {good, bad}, examples);
  EXPECT_THAT(page.str(), HasSubstr("### feature/shape: 1 of 2\n"));
  EXPECT_THAT(page.str(), HasSubstr("| torus |  | match | 100.00 % | 0.00000 |\n"));
  EXPECT_THAT(page.str(), HasSubstr("| sor |  | lute-error | | |\n"));
  EXPECT_THAT(page.str(), HasSubstr("| media | 2 | 1 | fog (unsupported) |\n"));
  EXPECT_THAT(page.str(), HasSubstr("| **all** | 3 | 2 | |\n"));
}

}  // namespace
}  // namespace lute::compare
