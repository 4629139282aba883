#include "compare/page_section.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lute::compare {
namespace {

TEST(PageSection, IsReplacedBetweenItsMarks) {
  const std::string begin = "<!-- lute-compare speed: begin -->\n", end = "<!-- lute-compare speed: end -->\n";
  EXPECT_EQ(with_section("head\n" + begin + "old\n" + end + "tail\n", "speed", "new\n"), "head\n" + begin + "new\n" + end + "tail\n");
  EXPECT_THROW(with_section("head\n" + end + begin, "speed", "new\n"), std::runtime_error);
  EXPECT_THROW(with_section("head\n" + begin + end, "sweep", "new\n"), std::runtime_error);
}

}  // namespace
}  // namespace lute::compare
