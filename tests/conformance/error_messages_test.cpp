// The errors of the golden scenes (tests/parser/diagnostic/errors.golden) beside POV-Ray's: the same scene is refused with the same
// words, but for those where lute says more.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "compare/process.hpp"
#include "compare/scratch_folder.hpp"
#include "tests/file_text.hpp"

namespace lute::compare {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = LUTE_SOURCE_DIR "/tests/parser/diagnostic";

struct Golden {
  std::string scene, message;  // the first error's
};

std::vector<Golden> golden_scenes() {
  const std::string text = test::file_text(kFolder / "errors.golden");
  const std::string scene_mark = "==== scene\n", says_mark = "---- says\n", error_mark = ": error: ";
  std::vector<Golden> all;
  for (std::size_t at = text.find(scene_mark); at != std::string::npos;) {
    const std::size_t says = text.find(says_mark, at), next = text.find(scene_mark, says);
    const std::size_t error = text.find(error_mark, says);
    Golden golden;
    golden.scene = text.substr(at + scene_mark.size(), says - at - scene_mark.size());
    if (!golden.scene.starts_with("#version")) {
      golden.scene = "#version 3.7; global_settings { assumed_gamma 1 }\n" + golden.scene;
    }
    golden.message = text.substr(error + error_mark.size(), text.find('\n', error) - error - error_mark.size());
    all.push_back(golden);
    at = next;
  }
  return all;
}

// Those that show a limit of lute's would keep POV-Ray busy for ever.
bool shows_a_limit(const Golden& golden) {
  for (const char* word : {"limit", "more memory", "too long", "too deeply", "more than the maximum", "too many components"}) {
    if (golden.message.find(word) != std::string::npos) return true;
  }
  return false;
}

// "Parse Error: TEXT", of which the console has broken the lines; "" if the scene is accepted or refused in another way.
std::string reference_message(const std::string& scene) {
  const ScratchFolder folder(kFolder / "errors");
  std::ofstream(folder.path() / "scene.pov", std::ios::binary) << scene;
  ProcessRequest request;
  request.arguments = {"povray", "+Iscene.pov", "+W1", "+H1", "-F", "-D"};
  request.working_directory = folder.path();
  request.standard_error = folder.path() / "said";
  request.time_limit = 20;
  run_process(request);
  const std::string said = test::file_text(request.standard_error);
  static const std::regex pattern(R"(line \d+: Parse Error: ([^]*?)\n(?:Fatal error|====))");
  std::smatch found;
  if (!std::regex_search(said, found, pattern)) return "";
  return std::regex_replace(found[1].str(), std::regex("\n"), "");
}

TEST(ErrorMessages, AreTheReferencesInAlmostAllCases) {
  int compared = 0, same = 0;
  std::string other;
  for (const Golden& golden : golden_scenes()) {
    if (shows_a_limit(golden)) continue;
    const std::string reference = reference_message(golden.scene);
    if (reference.empty()) continue;
    ++compared;
    if (reference == golden.message) ++same;
    else other += "lute:    " + golden.message + "\nPOV-Ray: " + reference + "\n";
  }
  RecordProperty("compared", compared);
  RecordProperty("same", same);
  EXPECT_GE(compared, 230);
  EXPECT_GE(same, compared * 8 / 10) << same << " of " << compared << " are the same\n" << other;
}

}  // namespace
}  // namespace lute::compare
