// A file of the scene: its text, its tokens (made once, of a large file piece by piece as reading comes to them) and its lines.
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
#include "parser/lexer/token_pages.hpp"

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

  Tokens tokens;                     // ends with kEnd, or with kMore while text is left
  std::vector<std::string> strings;  // of kString tokens
  std::vector<std::string> errors;   // of kError tokens
  std::vector<LiteralRun> runs;      // of kRun tokens
  std::uint32_t next_run = 0;        // where it is worth looking for a run again

  std::uint32_t lexed = 0;           // how much of the text the tokens are made of
  bool complete() const { return !tokens.empty() && tokens.back().kind == TokenKind::kEnd; }

  // Tokens that will not be read again are forgotten: those from `kept_from` on are there, and those of macros.
  std::uint32_t kept_from = 0;
  bool forgotten = false;  // some are: the file cannot be read a second time
  void forget_tokens(const Token* before);

  // Where skipped regions end, by the index of their first token (parser/directives).
  std::unordered_map<std::uint32_t, std::uint32_t> skip_targets;
  // Compiled expressions by the index of their first token, known directives by that of their `#`, of #while of its `(`; 0: none
  // (parser/expression, parser/directives). Only as long as needed.
  std::vector<std::uint32_t> expression_codes;
  std::uint32_t code_at(const Token* token) const {
    const std::uint32_t i = token_index(token);
    return i < expression_codes.size() ? expression_codes[i] : 0;
  }

  SourceFile() = default;
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;
  void set_text(FileText new_text) {
    storage = std::move(new_text);
    text = storage.view();
  }
  // Takes the text into memory: the file is about to change.
  void keep_text() {
    if (storage.follows_file()) set_text(FileText(std::string(text)));
  }

  SourceLocation locate(std::uint32_t offset) const;  // line and column, from 1
  // Without its line end; not much more than `most` bytes of it.
  std::string_view line(std::uint32_t number, std::size_t most = std::string_view::npos) const;
  std::uint32_t token_index(const Token* token) const { return static_cast<std::uint32_t>(token - tokens.data()); }

 private:
  // Lines are counted from the nearest mark in front of a place: a table of all lines of a large file would be large. The marks reach
  // as far as was asked for.
  struct LineMark {
    std::uint32_t offset = 0, line = 1, line_start = 0;
  };
  void count_lines(LineMark& here, std::uint32_t to) const;
  void find_lines(std::uint32_t to_offset, std::uint32_t to_line) const;
  mutable std::vector<LineMark> line_marks_{LineMark{}};
  mutable LineMark counted_;  // where the lines were counted to
  mutable LineMark located_;  // the place asked for last
  mutable std::size_t released_ = 0;
};

// Fills tokens, strings and errors from the whole text. `main_file`: a byte order mark is skipped. Specification chapter 10 §1.
void lex(SourceFile& file, Names& names, bool main_file);

// The same piece by piece, for reading a scene: the first piece, and then the next ones until the file is complete. The tokens of
// a piece take the place of the kMore token; a `#` never ends one. Long runs of literals in large files become kRun tokens.
void begin_lexing(SourceFile& file, Names& names, bool main_file);
void lex_more(SourceFile& file, Names& names);

// The next tokens of a run, from `position` on, which moves behind them; a kEnd token is added behind them. The run is read to its
// end when `position` is.
void lex_run(SourceFile& file, Names& names, const LiteralRun& run, std::uint32_t& position, Tokens& tokens);

// One past the last byte of the token that starts at `offset`, for marking it.
std::uint32_t token_end(const SourceFile& file, const Token& token);

}  // namespace lute
