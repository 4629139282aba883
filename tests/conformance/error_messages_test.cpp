// The errors of the golden scenes (tests/parser/diagnostic/errors.golden) beside POV-Ray's: each is refused in the same line of the same
// file with the same words, but for those that error_differences.golden lists, all of which lute tells differently on purpose:
// it says more, or refuses what POV-Ray lets pass.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/conformance/first_error.hpp"
#include "tests/golden.hpp"
#include "tests/parser/diagnostic/golden_scene_list.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = LUTE_SOURCE_DIR "/tests/parser/diagnostic";

struct Golden {
  std::string scene, error;  // the first one: "FILE:LINE: MESSAGE"
};

std::vector<Golden> golden_scenes() {
  std::vector<Golden> all;
  for (const auto& [scene, says] : test::read_golden_scenes(kFolder / "errors.golden").cases) {
    const std::string head = scene.starts_with("#version") ? "" : "#version 3.7; global_settings { assumed_gamma 1 }\n";
    all.push_back({head + scene, error_told_by_lute(says)});
  }
  return all;
}

// Those that show a limit of lute's would keep POV-Ray busy for ever.
bool shows_a_limit(const Golden& golden) {
  for (const char* word : {"limit", "more memory", "too long", "too deeply", "more than the maximum", "too many components", "turns more than"}) {
    if (golden.error.find(word) != std::string::npos) return true;
  }
  return false;
}

TEST(ErrorMessages, AreTheReferencesButForTheRecordedOnes) {
  std::vector<Golden> compared;
  std::vector<std::string> scenes;
  for (const Golden& golden : golden_scenes()) {
    EXPECT_NE(golden.error, "accepted") << golden.scene;
    if (shows_a_limit(golden)) continue;
    compared.push_back(golden);
    scenes.push_back(golden.scene);
  }
  EXPECT_GE(compared.size(), 240u);
  const std::vector<std::string> references = reference_errors(scenes, kFolder / "errors");
  std::string differences;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const auto& [scene, error] = compared[i];
    if (references[i] == error) continue;
    const std::size_t head = scene.starts_with("#version 3.7; global") ? scene.find('\n') + 1 : 0;
    differences += scene.substr(head) + "  lute:    " + error + "\n  POV-Ray: " + references[i] + "\n";
  }
  test::expect_golden(LUTE_SOURCE_DIR "/tests/conformance/error_differences.golden", differences);
}

}  // namespace
}  // namespace lute::compare
