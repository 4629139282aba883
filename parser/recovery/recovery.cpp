#include "parser/recovery/recovery.hpp"

#include <algorithm>

#include "parser/directives/directive.hpp"
#include "parser/directives/directive_words.hpp"
#include "parser/recovery/resume_point.hpp"

namespace lute {

namespace {

constexpr std::uint64_t kMostEventsBehindError = 2'000'000;
constexpr std::size_t kMostUntoldErrors = 10'000;
constexpr std::size_t kMostTokensBehindError = 1'000'000;  // that are searched for the next statement

// The author asked for the end, or the machine did.
bool ends_reading(const Diagnostic& diagnostic) {
  const std::string& code = diagnostic.code;
  return code == "given-up" || code == "error-directive" || code == "limit-memory" || code == "limit-tokens" || code == "limit-loop-turns";
}

}  // namespace

bool Recovery::within_budget() const {
  return errors_ == 0 || session_.stream.events - first_error_events_ < kMostEventsBehindError;
}

bool Recovery::follows_from_another(const Diagnostic& diagnostic) const {
  if (errors_ == 0) return false;
  if (diagnostic.code == "given-up") return true;
  if (told_.contains({diagnostic.where.file, diagnostic.where.line, diagnostic.where.column})) return true;
  if (lost_ && (diagnostic.code == "missing-end" || diagnostic.code == "mismatched-directive")) return true;
  if (diagnostic.code == "user-file") return true;  // nothing was written behind the first error
  if (error_ == nullptr) return false;
  // What is left of a broken statement.
  if (error_ == resumed_at_ && error_->kind != TokenKind::kName && diagnostic.code == "expected-token") return true;
  const bool undeclared = error_->kind == TokenKind::kName && session_.symbols.find(error_->index) == nullptr;
  return undeclared && (include_missing_ || names_.contains(error_->index));
}

bool Recovery::report(const Diagnostic& diagnostic) {
  if (!follows_from_another(diagnostic)) {
    if (errors_++ == 0) first_error_events_ = session_.stream.events;
    session_.diagnostics.report(diagnostic);
  } else {
    ++untold_;
  }
  told_.insert({diagnostic.where.file, diagnostic.where.line, diagnostic.where.column});
  if (diagnostic.code == "missing-include") include_missing_ = true;
  return errors_ < session_.options.limits.errors && untold_ < kMostUntoldErrors && !ends_reading(diagnostic);
}

bool Recovery::recover(const SceneError& error) {
  if (!report(error.diagnostic())) return false;
  if (start_ == nullptr || session_.stream.frames.empty()) return false;
  unwind();
  return within_budget() && move_on();
}

// Leaves the macros and files that the statement has entered, and the conditionals it has opened.
void Recovery::unwind() {
  TokenStream& stream = session_.stream;
  stream.unwind(frames_, conditionals_);
  session_.expressions.recording.reset();
  session_.expressions.stack.clear();
  session_.expressions.nested = false;
  session_.expressions.depth = 0;
  session_.nested_directives = 0;
  session_.open_blocks.clear();
  for (Conditional& open : stream.conditionals) open.last_turn = true;
}

bool Recovery::begins_statement(const Token& token) const {
  if (token.kind == TokenKind::kWord) return begins_top_level_statement(token.word);
  const Value* const value = session_.symbols.find_value(token.index);
  if (value == nullptr) return names_.contains(token.index);
  return value->holds<MacroPtr>() || value->holds<ObjectPtr>();
}

// `NAME = VALUE` was meant as a declaration.
void Recovery::note_assignments(const Token* from, const Token* to) {
  for (const Token* token = from; token < to; ++token) {
    if (token->kind == TokenKind::kName && token[1].kind == TokenKind::kEqual) names_.insert(token->index);
  }
}

bool Recovery::move_on() {
  TokenStream& stream = session_.stream;
  stream.read_ahead(kMostTokensBehindError);
  TokenFrame& frame = stream.frames.back();
  const Token* const first = frame.file->tokens.data();
  const auto in_frame = [&](const Token* token) { return token != nullptr && token >= first && token <= frame.end; };
  BrokenStatement broken;
  broken.file = frame.file;
  // A statement that began in a file which has ended since is over.
  broken.start = stream.frames.size() == frames_ && in_frame(start_) ? start_ : frame.cursor;
  broken.error = error_file_ == frame.file->index && in_frame(error_) ? error_ : frame.cursor;
  broken.error = std::max(broken.error, broken.start);
  broken.end = frame.end;
  broken.begins_statement = [this](const Token& token) { return begins_statement(token); };
  if (broken.start == frame.end && !frame.macro) return false;

  const ResumePoint point = find_resume_point(broken);
  names_.insert(point.names.begin(), point.names.end());
  note_assignments(broken.start, point.token);
  // Of an #if without its #, the #end is too many.
  lost_ |= point.lost || (error_ != nullptr && error_ == broken.start && opens_region(*error_));
  if (point.token->kind == TokenKind::kMore) return false;
  frame.cursor = point.token;
  resumed_at_ = point.token;
  ++stream.events;
  return true;
}

}  // namespace lute
