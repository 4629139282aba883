// Every statement, modifier, setting and directive of the language, each in a scene of its own (statements.txt: one a line), beside
// POV-Ray: both accept it, or both refuse it in the same line with the same words. statement_differences.golden lists those where
// that is not so, all of which are known: lute says more, or gives the place that POV-Ray leaves out.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/conformance/first_error.hpp"
#include "tests/file_text.hpp"
#include "tests/golden.hpp"

namespace lute::compare {
namespace {

const std::filesystem::path kFiles = LUTE_SOURCE_DIR "/tests/parser/diagnostic/errors";
const std::string kFolder = LUTE_SOURCE_DIR "/tests/conformance/";

TEST(Statements, AreAcceptedOrRefusedAsByTheReference) {
  std::istringstream scenes(test::file_text(kFolder + "statements.txt"));
  std::string differences;
  int compared = 0;
  for (std::string line; std::getline(scenes, line);) {
    if (line.empty() || line.starts_with("//")) continue;
    ++compared;
    const std::string head = line.starts_with("#version") ? "" : "#version 3.7; global_settings { assumed_gamma 1 }\n";
    const std::string scene = head + line + "\n";
    const std::string lute = error_told_by_lute(said_about(scene, kFiles, {LUTE_BINARY_DIR "/lute", "--check", "test.pov"}));
    const std::string reference = reference_error(scene, kFiles);
    if (lute != reference) differences += line + "\n  lute:    " + lute + "\n  POV-Ray: " + reference + "\n";
  }
  EXPECT_GE(compared, 700);
  test::expect_golden(kFolder + "statement_differences.golden", differences);
}

}  // namespace
}  // namespace lute::compare
