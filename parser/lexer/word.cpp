#include "parser/lexer/word.hpp"

#include <array>
#include <unordered_map>

namespace lute {

namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Word::kWordListEnd)> kSpellings = {
    "",
#define LUTE_WORD_SPELLING(enumerator, spelling) spelling,
    LUTE_WORDS(LUTE_WORD_SPELLING)
#undef LUTE_WORD_SPELLING
};

std::unordered_map<std::string_view, Word> make_index() {
  std::unordered_map<std::string_view, Word> index;
  for (std::size_t i = 1; i < kSpellings.size(); ++i) index.emplace(kSpellings[i], static_cast<Word>(i));
  return index;
}

}  // namespace

std::string_view spelling(Word word) { return kSpellings[static_cast<std::size_t>(word)]; }

std::optional<Word> find_word(std::string_view name) {
  static const std::unordered_map<std::string_view, Word> index = make_index();
  const auto found = index.find(name);
  if (found == index.end()) return std::nullopt;
  return found->second;
}

Word canonical(Word word) {
  switch (word) {
    case Word::kColour: return Word::kColor;
    case Word::kColourMap: return Word::kColorMap;
    case Word::kFadeColour: return Word::kFadeColor;
    case Word::kQuickColour: return Word::kQuickColor;
    case Word::kUseColour: return Word::kUseColor;
    default: return word;
  }
}

}  // namespace lute
