// Golden tests of every kind of error: the message, the place, what was found and what to write instead.
#include <gtest/gtest.h>

#include "tests/parser/diagnostic/golden_scenes.hpp"

namespace lute::test {
namespace {

const std::string kGolden = kDiagnosticFolder + "errors.golden";

TEST(ErrorMessages, AreAsRecorded) {
  ASSERT_GT(read_golden_scenes(kGolden).cases.size(), 200u);
  expect_golden_scenes(kGolden, true);
}

TEST(ErrorMessages, OfBeginnersAreAsRecorded) {
  const std::string golden = kDiagnosticFolder + "beginners.golden";
  ASSERT_GT(read_golden_scenes(golden).cases.size(), 100u);
  expect_golden_scenes(golden, true);
}

// Messages that no scene can bring forth in this test, each with its reason.
const std::set<std::string> kNotInScenes = {
    "Objects cannot be asked here: no engine is connected.",                    // only without the engine
    "Pigment and pattern functions need the engine, which is not connected.",   // the same
    "Cannot open input file '",                                                 // tests/app
    "version",                                                                  // a code: the message is put together
    "domain", "missing-semicolon", "bad-file", "scene-error",                   // codes as well
    "Reading behind an error takes too long.",                                  // not told
    "This cannot be used as a function.",                                       // guards a table
};

TEST(ErrorMessages, EveryKindIsRecorded) {
  const std::string all = read_golden_scenes(kGolden).all_said();
  const std::set<std::string> messages = messages_in_sources(std::regex(
      R"re((?:\bfail|fail_at|fail_after|\berror|error_expected|fail_expected|LexFailure|as_many|no_more)[({,]\s*(?:[\w.]+,\s*)?"((?:[^"\\]|\\.)*)")re"));
  ASSERT_GT(messages.size(), 150u);
  for (const std::string& message : messages) {
    if (kNotInScenes.contains(message)) continue;
    const bool expected = all.find("Expected '" + message + "'") != std::string::npos;
    EXPECT_TRUE(expected || (message.size() > 3 && all.find(message) != std::string::npos)) << message;
  }
}

}  // namespace
}  // namespace lute::test
