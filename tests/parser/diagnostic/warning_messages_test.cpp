// Golden tests of every kind of warning and possible error: the message and its place.
#include <gtest/gtest.h>

#include "tests/parser/diagnostic/golden_scenes.hpp"

namespace lute::test {
namespace {

const std::string kGolden = kDiagnosticFolder + "warnings.golden";

TEST(WarningMessages, AreAsRecorded) {
  ASSERT_GT(read_golden_scenes(kGolden).cases.size(), 60u);
  expect_golden_scenes(kGolden, false);
}

// Messages that are not warnings' own texts, or that no scene can bring forth in this test, each with its reason.
const std::set<std::string> kNotInScenes = {
    "File '",  // found in spite of its case: tests/parser/directives/include_test.cpp
};

// The beginnings of texts that are put together count as much as whole ones.
TEST(WarningMessages, EveryKindIsRecorded) {
  const std::string all = read_golden_scenes(kGolden).all_said();
  const std::set<std::string> messages = messages_in_sources(
      std::regex(R"re((?:\bwarn|\bwarning|\bpossible_error)\(\s*(?:std::string\()?"((?:[^"\\]|\\.)*)")re"));
  ASSERT_GT(messages.size(), 55u);
  for (const std::string& message : messages) {
    if (kNotInScenes.contains(message)) continue;
    EXPECT_NE(all.find(message), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace lute::test
