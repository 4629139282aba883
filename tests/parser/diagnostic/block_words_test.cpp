#include "parser/diagnostic/block_words.hpp"

#include <gtest/gtest.h>

#include "parser/lexer/word.hpp"

namespace lute::test {
namespace {

constexpr std::string_view kBlocks[] = {"pigment", "normal", "texture", "finish", "interior", "camera", "light_source",
                                        "global_settings", "box", "cone", "cylinder", "disc", "plane", "sphere", "torus"};

TEST(BlockWords, AreReservedWords) {
  for (const std::string_view block : kBlocks) {
    EXPECT_FALSE(block_words(block).empty()) << block;
    for (const std::string_view word : block_words(block)) EXPECT_TRUE(find_word(word)) << block << ": " << word;
  }
}

TEST(BlockWords, AreThoseOfTheBlock) {
  EXPECT_TRUE(is_block_word("normal", "bumps"));
  EXPECT_TRUE(is_block_word("interior", "ior"));
  EXPECT_FALSE(is_block_word("finish", "ior"));
  EXPECT_FALSE(is_block_word("union", "sphere"));
}

}  // namespace
}  // namespace lute::test
