#include "parser/diagnostic/suggestion.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "parser/diagnostic/block_words.hpp"
#include "parser/directives/directive_words.hpp"
#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

namespace {

// The word can stand where this was expected.
bool fits(Word word, std::string_view expected, bool behind_hash) {
  if (behind_hash) return is_directive(word);
  if (expected == "object or directive") return begins_top_level_statement(word);
  if (expected != "numeric expression" && expected != "operator") return true;
  Item item;
  item.token.kind = TokenKind::kWord;
  item.token.word = word;
  return starts_number(item);
}

void add_keywords(std::vector<std::string_view>& candidates, std::string_view expected, bool behind_hash) {
  for (int i = 1; i < static_cast<int>(Word::kWordListEnd); ++i) {
    const Word word = static_cast<Word>(i);
    if (fits(word, expected, behind_hash)) candidates.push_back(spelling(word));
  }
}

// A statement begins with no declared name but that of a macro.
void add_declared(Session& session, std::vector<std::string_view>& candidates, std::string_view expected) {
  session.symbols.for_each_name([&](NameId known) {
    const Value* const value = session.symbols.find_value(known);
    if (expected == "object or directive" && (value == nullptr || !value->holds<MacroPtr>())) return;
    candidates.push_back(session.names.text(known));
  });
}

std::string about_library(Session& session, std::string_view name) {
  if (!session.library_names) session.library_names.emplace(session.options.library_paths);
  const auto is_read = [&](const std::string& include) {
    return std::ranges::any_of(session.files, [&](const auto& file) {
      return std::filesystem::path(file->name).filename().string() == include;
    });
  };
  const std::span<const std::string> includes = session.library_names->files_of(name);
  const auto other = std::ranges::find_if_not(includes, is_read);
  if (other != includes.end()) return "it is declared in " + *other + ": #include \"" + *other + "\"";
  return includes.empty() ? "" : includes.front() + ", which is included, declares it: did an #undef or #if take it away?";
}

std::string did_you_mean(std::string_view name) { return name.empty() ? "" : "did you mean '" + std::string(name) + "'?"; }

}  // namespace

std::string suggestion(Session& session, const Item& found, std::string_view expected, std::string_view block) {
  if (!found.is(TokenKind::kName) || expected == "string expression") return "";
  const std::string_view name = session.names.text(found.token.index);
  const SourceFile& file = *session.files[found.file];
  const bool behind_hash = found.source != nullptr && found.source > file.tokens.data() && found.source[-1].kind == TokenKind::kHash;
  std::vector<std::string_view> keywords;
  // Every name of one or two letters is near to some keyword.
  if (name.size() >= 3) add_keywords(keywords, expected, behind_hash);
  if (behind_hash) return did_you_mean(nearest_name(name, keywords));

  const bool is_capital = name.front() >= 'A' && name.front() <= 'Z';
  if (expected == "object or directive" && is_capital) {
    const std::string small = static_cast<char>(name.front() - 'A' + 'a') + std::string(name.substr(1));
    if (std::ranges::find(keywords, small) != keywords.end()) return did_you_mean(small);
  }
  if (std::string hint = about_library(session, name); !hint.empty()) return hint;
  // Of equally near names the first counts.
  std::vector<std::string_view> candidates = block_words(block);
  const bool is_known_block = !candidates.empty();
  add_declared(session, candidates, expected);
  const std::string_view nearest = is_known_block ? nearest_name(name, candidates) : std::string_view();
  if (!nearest.empty()) return did_you_mean(nearest);
  if (is_known_block && name.size() <= 3) return "";  // what is near does not belong here
  candidates.insert(candidates.end(), keywords.begin(), keywords.end());
  return did_you_mean(nearest_name(name, candidates));
}

}  // namespace lute
