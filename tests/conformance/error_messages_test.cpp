// The errors of the golden scenes (tests/parser/diagnostic/errors.golden) beside POV-Ray's: each is refused in the same line of the same
// file with the same words, but for those that error_differences.golden lists, all of which lute tells differently on purpose:
// it says more, or refuses what POV-Ray lets pass.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/conformance/first_error.hpp"
#include "tests/file_text.hpp"
#include "tests/golden.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = LUTE_SOURCE_DIR "/tests/parser/diagnostic";

struct Golden {
  std::string scene, error;  // the first one: "FILE:LINE: MESSAGE"
};

std::vector<Golden> golden_scenes() {
  const std::string text = test::file_text(kFolder / "errors.golden");
  const std::string scene_mark = "==== scene\n", says_mark = "---- says\n";
  std::vector<Golden> all;
  for (std::size_t at = text.find(scene_mark); at != std::string::npos;) {
    const std::size_t says = text.find(says_mark, at), next = text.find(scene_mark, says);
    Golden golden;
    golden.scene = text.substr(at + scene_mark.size(), says - at - scene_mark.size());
    if (!golden.scene.starts_with("#version")) {
      golden.scene = "#version 3.7; global_settings { assumed_gamma 1 }\n" + golden.scene;
    }
    golden.error = error_told_by_lute(text.substr(says, next - says));
    all.push_back(golden);
    at = next;
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
  int compared = 0;
  std::string differences;
  for (const Golden& golden : golden_scenes()) {
    EXPECT_NE(golden.error, "accepted") << golden.scene;
    if (shows_a_limit(golden)) continue;
    ++compared;
    const std::string reference = reference_error(golden.scene, kFolder / "errors");
    if (reference == golden.error) continue;
    const std::size_t head = golden.scene.starts_with("#version 3.7; global") ? golden.scene.find('\n') + 1 : 0;
    differences += golden.scene.substr(head) + "  lute:    " + golden.error + "\n  POV-Ray: " + reference + "\n";
  }
  EXPECT_GE(compared, 240);
  test::expect_golden(LUTE_SOURCE_DIR "/tests/conformance/error_differences.golden", differences);
}

}  // namespace
}  // namespace lute::compare
