// The words that may stand in a block. For messages: which of them a misspelt name is meant to be, and where a word belongs.
#pragma once

#include <string_view>
#include <vector>

namespace lute {

// Of `pigment`, `finish`, ...: empty for a block that is not known here, or that holds any object.
std::vector<std::string_view> block_words(std::string_view block);

// The block is known and has the word.
bool is_block_word(std::string_view block, std::string_view word);

}  // namespace lute
