// A file of the scene: its text, its tokens (made once, never changed) and its lines.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/scene/source_location.hpp"
#include "parser/lexer/file_text.hpp"
#include "parser/lexer/token.hpp"

namespace lute {

// Interns names. The reserved words come first: an id below Word::kWordListEnd is that word.
class Names {
 public:
  Names();
  NameId intern(std::string_view name);
  std::string_view text(NameId id) const { return texts_[id]; }
  std::size_t size() const { return texts_.size(); }
  static bool is_word(NameId id) { return id < static_cast<NameId>(Word::kWordListEnd); }

 private:
  void grow();

  std::deque<std::string> texts_;
  std::vector<NameId> buckets_;  // open addressing; kFree where empty
  static constexpr NameId kFree = 0xFFFFFFFF;
};

// Text of nothing but literals, commas and vectors, as in meshes: its tokens would take many times the memory of what it says.
struct LiteralRun {
  std::uint32_t begin = 0, end = 0;  // in the text
};

struct SourceFile {
  std::string name;  // as it was found
  std::string_view text;
  FileText storage;  // of the text
  std::uint32_t index = 0;  // in the file table
  bool byte_order_mark = false;

  std::vector<Token> tokens;         // ends with kEnd
  std::vector<std::string> strings;  // of kString tokens
  std::vector<std::string> errors;   // of kError tokens
  std::vector<LiteralRun> runs;      // of kRun tokens

  // Where skipped regions end, by the index of their first token (parser/directives).
  std::unordered_map<std::uint32_t, std::uint32_t> skip_targets;
  // Compiled expressions by the index of their first token, known directives by that of their `#`, of #while of its `(`; 0: none
  // (parser/expression, parser/directives). Empty until one is compiled.
  std::vector<std::uint32_t> expression_codes;
  std::uint32_t code_at(const Token* token) const { return expression_codes.empty() ? 0 : expression_codes[token_index(token)]; }

  SourceFile() = default;
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;
  void set_text(FileText new_text) {
    storage = std::move(new_text);
    text = storage.view();
  }

  SourceLocation locate(std::uint32_t offset) const;  // line and column, from 1
  std::string_view line(std::uint32_t number) const;  // without its line end
  std::uint32_t token_index(const Token* token) const { return static_cast<std::uint32_t>(token - tokens.data()); }

 private:
  // Lines are counted from the nearest mark in front of a place: a table of all lines of a large file would be large.
  struct LineMark {
    std::uint32_t offset = 0, line = 1, line_start = 0;
  };
  void find_lines() const;
  mutable std::vector<LineMark> line_marks_;
};

// Fills tokens, strings and errors from the text. `main_file`: a byte order mark is skipped. `runs`: long runs of literals in large
// files become kRun tokens. Specification chapter 10 §1.
void lex(SourceFile& file, Names& names, bool main_file, bool runs = false);

// The next tokens of a run, from `position` on, which moves behind them; a kEnd token is added behind them. The run is read to its
// end when `position` is.
void lex_run(SourceFile& file, Names& names, const LiteralRun& run, std::uint32_t& position, std::vector<Token>& tokens);

// One past the last byte of the token that starts at `offset`, for marking it.
std::uint32_t token_end(const SourceFile& file, const Token& token);

}  // namespace lute
