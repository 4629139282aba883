#include "compare/figures.hpp"

#include <gtest/gtest.h>

namespace lute::compare {
namespace {

TEST(Figures, MedianIsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3, 1, 100}), 3);
  EXPECT_EQ(median({4, 1, 100, 3}), 3.5);
}

TEST(Figures, CsvFieldsAreQuotedOnlyWhereTheyMustBe) {
  EXPECT_EQ(csv_field("+AM2 +A0.1"), "+AM2 +A0.1");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"x\""), "\"say \"\"x\"\"\"");
}

TEST(Figures, WordsAreWithoutTheirBlanks) { EXPECT_EQ(words_of("  +AM2\t+A0.1 "), (std::vector<std::string>{"+AM2", "+A0.1"})); }

}  // namespace
}  // namespace lute::compare
