// Every statement, modifier, setting and directive of the language, each in a scene of its own (statements.txt: one a line), beside
// POV-Ray: both accept it, or both refuse it in the same line with the same words. statement_differences.golden lists those where
// that is not so, all of which are known: lute says more, or gives the place that POV-Ray leaves out.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/conformance/first_error.hpp"
#include "tests/file_text.hpp"
#include "tests/golden.hpp"

namespace lute::compare {
namespace {

const std::filesystem::path kFiles = LUTE_SOURCE_DIR "/tests/parser/diagnostic/errors";
const std::string kFolder = LUTE_SOURCE_DIR "/tests/conformance/";

TEST(Statements, AreAcceptedOrRefusedAsByTheReference) {
  std::istringstream text(test::file_text(kFolder + "statements.txt"));
  std::vector<std::string> lines, scenes;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.starts_with("//")) continue;
    const std::string head = line.starts_with("#version") ? "" : "#version 3.7; global_settings { assumed_gamma 1 }\n";
    lines.push_back(line);
    scenes.push_back(head + line + "\n");
  }
  EXPECT_GE(lines.size(), 700u);
  const std::vector<std::string> references = reference_errors(scenes, kFiles);
  std::string differences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string lute = error_told_by_lute(said_about(scenes[i], kFiles, {LUTE_BINARY_DIR "/lute", "--check", "test.pov"}));
    if (lute != references[i]) differences += lines[i] + "\n  lute:    " + lute + "\n  POV-Ray: " + references[i] + "\n";
  }
  test::expect_golden(kFolder + "statement_differences.golden", differences);
}

}  // namespace
}  // namespace lute::compare
