#include "parser/directives/token_stream.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "parser/directives/directive.hpp"
#include "parser/value/array.hpp"

namespace lute {

TokenStream::Aside::Aside(TokenStream& stream, bool after_operand_ok)
    : stream_(stream), window_size_(stream.window_size_), after_operand_ok_(stream.after_operand_ok_) {
  for (int i = 0; i < window_size_; ++i) window_[i] = std::move(stream.window_[i]);
  stream.window_size_ = 0;
  stream.after_operand_ok_ = after_operand_ok;
}

TokenStream::Aside::~Aside() {
  for (int i = 0; i < window_size_; ++i) stream_.window_[i] = std::move(window_[i]);
  stream_.window_size_ = window_size_;
  stream_.after_operand_ok_ = after_operand_ok_;
}

const Item& TokenStream::peek_statement() {
  if (window_size_ == 0) {
    between_statements_ = true;
    fetch(true);
  } else {
    session_.recovery.begin_statement(frames.size(), conditionals.size(), window_[0].source);
  }
  return window_[0];
}

Item TokenStream::take() {
  if (window_size_ == 0) fetch(true);
  Item item = std::move(window_[0]);
  if (item.token.kind == TokenKind::kEnd) {  // the end stays, however often it is taken
    window_[0] = item;
  } else {
    if (window_size_ == 2) window_[0] = std::move(window_[1]);
    --window_size_;
  }
  last_file = item.file;
  last_token = item.source;
  return item;
}

void TokenStream::put_back(Item item) {
  assert(window_size_ < 2);
  // Back to its frame if it still lies there in front of the cursor: then compiled code can take over.
  if (window_size_ == 0 && item.subscripts == 0 && frames.back().cursor == item.source + 1) {
    frames.back().cursor = item.source;
    return;
  }
  if (window_size_ == 1) window_[1] = std::move(window_[0]);
  window_[0] = std::move(item);
  ++window_size_;
}

void TokenStream::unread() {
  if (window_size_ != 1) return;
  frames.back().cursor = window_[0].source;
  window_size_ = 0;
}

bool TokenStream::at_written(TokenKind kind) {
  if (window_size_ > 0) return window_[0].is(kind);
  settle();
  const TokenFrame& frame = frames.back();
  return frame.cursor != frame.end && frame.cursor->kind == kind;
}

bool TokenStream::at_written(Word word) {
  if (window_size_ > 0) return window_[0].is(word);
  settle();
  const TokenFrame& frame = frames.back();
  return frame.cursor != frame.end && frame.cursor->kind == TokenKind::kWord && frame.cursor->word == word;
}

bool TokenStream::ends_argument() {
  if (window_size_ == 0) {
    settle();
    const TokenFrame& frame = frames.back();
    if (frame.cursor != frame.end && frame.cursor->kind != TokenKind::kHash && frame.cursor->kind != TokenKind::kName) {
      return frame.cursor->kind == TokenKind::kComma || frame.cursor->kind == TokenKind::kRightParen;
    }
  }
  const Item& next = peek();
  return next.is(TokenKind::kComma) || next.is(TokenKind::kRightParen);
}

void TokenStream::fail_unreadable(const TokenFrame& frame) {
  Item item;
  item.token = *frame.cursor;
  item.file = frame.file->index;
  item.source = frame.cursor;
  session_.fail_at(frame.file->errors[frame.cursor->index], "unreadable-text", item);
}

void TokenStream::leave_run(TokenFrame& frame) {
  frame.cursor = frame.behind_run;
  frame.end = frame.end_behind_run;
  frame.behind_run = nullptr;
}

// The next piece of a large file: the token at its former end is another one now.
void TokenStream::lex_on(SourceFile& file) {
  lex_more(file, session_.names);
  const Token* const end = file.tokens.data() + file.tokens.size() - 1;
  for (TokenFrame& frame : frames) {
    if (frame.file == &file && !frame.macro) (frame.in_run() ? frame.end_behind_run : frame.end) = end;
  }
}

// Between two statements: of a large file that is not inside a loop or a macro, what lies behind is not read again.
void TokenStream::forget_passed(const Token* before) {
  constexpr std::ptrdiff_t kMany = 1 << 16, kLookedAtByMessages = 1 << 10;
  const TokenFrame& frame = frames.back();
  SourceFile& file = *frame.file;
  if (frame.macro || frame.in_run() || before - (file.tokens.data() + file.kept_from) < kMany || repeating_ > 0) return;
  const auto same = [&file](const TokenFrame& other) { return other.file == &file; };
  if (std::ranges::count_if(frames, same) > 1) return;
  file.forget_tokens(before - kLookedAtByMessages);
}

void TokenStream::keep(const Macro& macro) {
  macro.file->kept_from = std::max(macro.file->kept_from, macro.file->token_index(macro.end) + 2);
}

void TokenStream::read_ahead(std::size_t tokens) {
  const TokenFrame& frame = frames.back();
  if (frame.macro) return;
  const Token* const from = frame.in_run() ? frame.behind_run : frame.cursor;
  while (!frame.file->complete() && frame.file->tokens.size() - frame.file->token_index(from) <= tokens) lex_on(*frame.file);
}

// True if the cursor has moved to another piece of a run, or behind it, or if more of the file was read.
bool TokenStream::settle_once() {
  TokenFrame& frame = frames.back();
  if (!frame.in_run()) {
    if (frame.cursor->kind == TokenKind::kMore && !frame.macro) {
      lex_on(*frame.file);
      return true;
    }
    if (frame.cursor == frame.end || frame.cursor->kind != TokenKind::kRun) return false;
    frame.run = frame.cursor->index;
    frame.run_position = frame.file->runs[frame.run].begin;
    frame.behind_run = frame.cursor + 1;
    frame.end_behind_run = frame.end;
  } else if (frame.cursor != frame.end) {
    return false;
  } else if (frame.run_position == frame.file->runs[frame.run].end) {
    leave_run(frame);
    return true;
  }
  frame.piece ^= 1;
  Tokens& piece = pieces_[frame.piece];
  lex_run(*frame.file, session_.names, frame.file->runs[frame.run], frame.run_position, piece);
  frame.cursor = piece.data();
  frame.end = piece.data() + piece.size() - 1;
  return true;
}

void TokenStream::settle() {
  while (settle_once()) {
  }
}

// Ends the innermost frame if it has no token left.
bool TokenStream::at_frame_end() {
  if (settle_once()) return true;
  TokenFrame& frame = frames.back();
  if (frame.macro) {
    if (frame.cursor != frame.end) return false;
    leave_macro();
    return true;
  }
  if (frame.cursor->kind == TokenKind::kError) fail_unreadable(frame);
  if (frame.cursor->kind != TokenKind::kEnd || frames.size() == 1) return false;
  for (const Conditional& open : conditionals) {
    if (open.frame + 1 != frames.size()) continue;
    if (open.kind == Conditional::Kind::kWhile || open.kind == Conditional::Kind::kFor) {
      session_.fail(open.kind == Conditional::Kind::kWhile ? "#while loop did not end in file where it started."
                                                           : "#for loop did not end in file where it started.",
                    "loop-across-files");
    }
  }
  ++events;
  frames.pop_back();
  session_.symbols.pop_table();
  return true;
}

void TokenStream::fetch(bool directives_allowed) {
  assert(window_size_ == 0);
  const bool between_statements = std::exchange(between_statements_, false);
  for (;;) {
    if (between_statements) {
      session_.recovery.begin_statement(frames.size(), conditionals.size(), frames.back().cursor);
      forget_passed(frames.back().cursor);
    }
    session_.resources.count_token();
    if (at_frame_end()) continue;
    TokenFrame& frame = frames.back();
    Item item;
    item.token = *frame.cursor;
    item.file = frame.file->index;
    item.source = frame.cursor;
    switch (item.token.kind) {
      case TokenKind::kHash:
        if (!directives_allowed) break;
        if (repeating_ == 0 || !run_known_directive(session_)) run_directive(session_);
        continue;
      case TokenKind::kEnd:
        if (!conditionals.empty()) session_.fail_missing_end(item);
        window_[0] = std::move(item);
        window_size_ = 1;
        return;
      case TokenKind::kName: {
        ++frame.cursor;
        resolve(item, true);
        const MacroPtr* macro = item.slot ? item.slot->get_if<MacroPtr>() : nullptr;
        if (macro != nullptr) {
          call_macro(session_, MacroPtr(*macro), item);
          continue;
        }
        window_[0] = std::move(item);
        window_size_ = 1;
        return;
      }
      default: break;
    }
    ++frames.back().cursor;
    window_[0] = std::move(item);
    window_size_ = 1;
    return;
  }
}

void TokenStream::warn_deprecated(Deprecation& deprecation, const Item& item) {
  const bool same_use = deprecation.use == item.source && deprecation.use_event == events;
  if (same_use || (deprecation.once && deprecation.told)) return;
  deprecation.told = true;
  deprecation.use = item.source;
  deprecation.use_event = events;
  last_file = item.file;
  last_token = item.source;
  session_.warn(deprecation.message, "deprecated");
}

// Looks a name up: an identifier if it is declared. The frame's cursor is behind the name.
void TokenStream::resolve(Item& item, bool read_subscripts) {
  SymbolTable::Entry* entry = session_.symbols.find(item.token.index);
  if (entry == nullptr) return;
  item.token.kind = TokenKind::kIdentifier;
  item.slot = entry->slot;
  item.depth = entry->depth;
  if (entry->deprecation) warn_deprecated(*entry->deprecation, item);
  if (!read_subscripts) return;
  // An element of an array of arrays may be subscripted again.
  while (const ArrayPtr* array = item.slot->get_if<ArrayPtr>()) {
    settle();
    const TokenFrame& frame = frames.back();
    if (frame.cursor == frame.end || frame.cursor->kind != TokenKind::kLeftSquare) break;
    const ArrayPtr keep = *array;
    const bool first = item.subscripts == 0;
    const std::size_t index = select_element(session_, *keep, item.subscripts);
    item.slot = ArrayElements::reference(keep, index);
    ++item.depth;
    if (!first) session_.expressions.recording.reset();
  }
}

Item TokenStream::peek_raw() {
  while (at_frame_end()) {
  }
  const TokenFrame& frame = frames.back();
  Item item;
  item.token = *frame.cursor;
  item.file = frame.file->index;
  item.source = frame.cursor;
  if (item.token.kind == TokenKind::kName) {
    const SymbolTable::Entry* entry = session_.symbols.find(item.token.index);
    if (entry != nullptr) {
      item.token.kind = TokenKind::kIdentifier;
      item.slot = entry->slot;
      item.depth = entry->depth;
    }
  }
  return item;
}

Item TokenStream::take_raw() {
  assert(window_size_ == 0);
  Item item = peek_raw();
  if (item.token.kind != TokenKind::kEnd) ++frames.back().cursor;
  last_file = item.file;
  last_token = item.source;
  return item;
}

void TokenStream::look_for_semicolon() {
  if (window_size_ == 0 && peek_raw().is(TokenKind::kSemicolon)) take_raw();
}

void TokenStream::push_conditional(Conditional conditional) {
  if (conditionals.size() >= kMostConditionals) session_.fail("Too many nested conditionals or macros.", "nesting");
  conditional.frame = static_cast<std::uint32_t>(frames.size() - 1);
  using Kind = Conditional::Kind;
  if (conditional.kind == Kind::kWhile || conditional.kind == Kind::kFor) ++repeating_;
  conditionals.push_back(conditional);
}

void TokenStream::pop_conditional() {
  using Kind = Conditional::Kind;
  if (conditionals.back().kind == Kind::kWhile || conditionals.back().kind == Kind::kFor) --repeating_;
  conditionals.pop_back();
}

void TokenStream::enter_file(SourceFile& file) {
  std::size_t open_files = 0;
  for (const TokenFrame& frame : frames) open_files += frame.macro ? 0 : 1;
  if (open_files >= kMostFiles) session_.fail("Too many nested include files.", "nesting");
  if (!frames.empty()) {
    if (session_.symbols.table_count() >= SymbolTable::kMostTables) {
      session_.fail("Too many nested symbol tables", "nesting");
    }
    session_.symbols.push_table();
  }
  ++events;
  frames.push_back({&file, file.tokens.data(), file.tokens.data() + file.tokens.size() - 1, nullptr});
}

// The parameters' table was pushed by the caller.
void TokenStream::enter_macro(MacroPtr macro) {
  ++events;
  ++repeating_;
  const Token* const begin = macro->begin;
  const Token* const end = macro->end;
  frames.push_back({macro->file, begin, end, std::move(macro)});
  Conditional call;
  call.kind = Conditional::Kind::kMacro;
  push_conditional(call);
}

void TokenStream::leave_macro() {
  if (conditionals.empty() || conditionals.back().kind != Conditional::Kind::kMacro ||
      conditionals.back().frame + 1 != frames.size()) {
    session_.fail("Mis-matched '#end'.", "mismatched-directive");
  }
  ++events;
  --repeating_;
  conditionals.pop_back();
  session_.symbols.pop_table();
  frames.pop_back();
}

void TokenStream::unwind(std::size_t frame_count, std::size_t conditional_count) {
  while (conditionals.size() > conditional_count) {
    if (conditionals.back().kind == Conditional::Kind::kMacro) --repeating_;
    pop_conditional();
  }
  while (frames.size() > frame_count) {
    frames.pop_back();
    session_.symbols.pop_table();
  }
  for (TokenFrame& frame : frames) {
    if (frame.in_run()) leave_run(frame);
  }
  window_size_ = 0;
  after_operand_ok_ = true;
  between_statements_ = false;
}

}  // namespace lute
