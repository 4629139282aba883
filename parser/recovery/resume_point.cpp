#include "parser/recovery/resume_point.hpp"

#include <algorithm>

#include "parser/directives/directive_words.hpp"

namespace lute {

namespace {

class Search {
 public:
  explicit Search(const BrokenStatement& broken)
      : broken_(broken), start_line_(line(broken.start)), start_column_(indentation(broken.start)) {}

  ResumePoint run() {
    const Token* p = broken_.start;
    while (p < broken_.end && p->kind != TokenKind::kEnd && result_.token == nullptr) p = step(p);
    if (result_.token == nullptr) give_up(p);
    return std::move(result_);
  }

 private:
  std::uint32_t line(const Token* token) const { return broken_.file->locate(token->offset).line; }

  bool first_of_line(const Token* token) const {
    if (token == broken_.file->tokens.data()) return true;
    const std::uint32_t before = token[-1].offset;
    return broken_.file->text.substr(before, token->offset - before).find_first_of("\r\n") != std::string_view::npos;
  }

  // Column of the first token on the line.
  std::uint32_t indentation(const Token* token) const {
    const SourceLocation here = broken_.file->locate(token->offset);
    const std::uint32_t line_start = token->offset - (here.column - 1);
    const auto first = std::lower_bound(broken_.file->tokens.data(), token, line_start,
                                        [](const Token& t, std::uint32_t offset) { return t.offset < offset; });
    return first->offset - line_start + 1;
  }

  // Behind the error, or the error itself if the statement was read up to there.
  bool behind(const Token* token) const { return token > broken_.error || (token == broken_.error && token != broken_.start); }

  void found(const Token* token) { result_.token = token; }

  void give_up(const Token* end) {
    result_.lost = fallback_ == nullptr;
    result_.token = fallback_ == nullptr ? end : fallback_;
  }

  const Token* step(const Token* p) {
    if (p->kind == TokenKind::kHash && p + 1 < broken_.end && is_directive(p[1])) return directive(p);
    if (behind(p) && regions_ == 0 && begins_line_of_statement(p)) {
      if (braces_ == 0) {
        found(p);
        return p;
      }
      if (fallback_ == nullptr && indentation(p) <= start_column_) fallback_ = p;
    }
    switch (p->kind) {
      case TokenKind::kLeftBrace: ++braces_; break;
      case TokenKind::kRightBrace: close(p); break;
      case TokenKind::kSemicolon:
        if (braces_ == 0 && regions_ == 0 && p >= broken_.error) found(p + 1);
        break;
      default: break;
    }
    return p + 1;
  }

  bool begins_line_of_statement(const Token* p) const {
    const bool candidate = p->kind == TokenKind::kWord || p->kind == TokenKind::kName;
    return candidate && broken_.begins_statement(*p) && first_of_line(p);
  }

  void close(const Token* p) {
    if (--braces_ > 0) return;
    braces_ = 0;
    if (regions_ > 0 || p < broken_.error) return;
    const bool well_placed = line(p) == start_line_ || (first_of_line(p) && indentation(p) == start_column_);
    if (fallback_ != nullptr && !well_placed) {
      found(fallback_);
      return;
    }
    const Token* next = p + 1;
    while (next < broken_.end && next->kind == TokenKind::kSemicolon) ++next;
    found(next);
  }

  const Token* directive(const Token* hash) {
    const Word word = hash[1].word;
    if (word == Word::kEnd || selects_branch(word)) {
      if (regions_ == 0) {  // of a conditional around the statement
        found(hash == broken_.start ? hash + 2 : hash);
        return hash;
      }
      if (word != Word::kEnd) return other_branch(hash + 2);
      // A region that is itself the broken statement ends here.
      if (--regions_ == 0 && broken_is_region() && behind(hash)) found(hash + 2);
      return hash + 2;
    }
    const bool declares = word == Word::kDeclare || word == Word::kLocal || word == Word::kMacro || word == Word::kFopen;
    if (regions_ == 0 && behind(hash)) {
      if (braces_ == 0) {
        found(hash);
        return hash;
      }
      if (declares && fallback_ == nullptr && first_of_line(hash) && indentation(hash) <= start_column_) fallback_ = hash;
    }
    if (declares && hash + 2 < broken_.end && hash[2].kind == TokenKind::kName) result_.names.push_back(hash[2].index);
    if (opens_region(word)) ++regions_;
    return hash + 2;
  }

  bool broken_is_region() const {
    return broken_.start->kind == TokenKind::kHash && broken_.start + 1 < broken_.end && opens_region(broken_.start[1]);
  }

  // Only the first branch of a conditional counts: the braces of the others would count twice. To the conditional's #end.
  const Token* other_branch(const Token* p) const {
    for (int depth = 0; p < broken_.end; ++p) {
      if (p->kind != TokenKind::kHash || p + 1 == broken_.end || p[1].kind != TokenKind::kWord) continue;
      if (opens_region(p[1])) ++depth;
      if (p[1].word == Word::kEnd && depth-- == 0) return p;
    }
    return p;
  }

  const BrokenStatement& broken_;
  std::uint32_t start_line_, start_column_;
  int braces_ = 0, regions_ = 0;
  const Token* fallback_ = nullptr;  // the best place by indentation
  ResumePoint result_;
};

}  // namespace

ResumePoint find_resume_point(const BrokenStatement& broken) { return Search(broken).run(); }

}  // namespace lute
