// The live token stream: what remains of the scene's text when all directives are executed and all macro calls replaced by
// their bodies. Peeking executes what stands in front of the next token.
//
// A frame is a range of a file's tokens that is being read: a file, or a macro's body. Directives and macro calls are not
// executed everywhere: `fetch` is told whether they may be (specification chapter 10 §2).
#pragma once

#include <cstdint>
#include <vector>

#include "parser/directives/macro.hpp"
#include "parser/lexer/source_file.hpp"
#include "parser/reader.hpp"

namespace lute {

struct Deprecation;

struct TokenFrame {
  SourceFile* file = nullptr;
  const Token* cursor = nullptr;
  const Token* end = nullptr;  // of a macro: its `#end`; of a file: its kEnd token
  MacroPtr macro;              // null for a file

  // While a run of literals is read: cursor and end are those of a piece of it.
  const Token* behind_run = nullptr;  // where reading goes on then; null: no run is being read
  const Token* end_behind_run = nullptr;
  std::uint32_t run = 0, run_position = 0;
  int piece = 0;
  bool in_run() const { return behind_run != nullptr; }
};

// An open #if, #while, #for, #switch or macro call.
struct Conditional {
  enum class Kind : std::uint8_t { kIf, kElse, kWhile, kFor, kSwitch, kSwitchHead, kMacro };  // kSwitchHead: in front of the first #case
  Kind kind = Kind::kIf;
  std::uint32_t frame = 0;         // depth of the frame it began in
  const Token* start = nullptr;    // its directive; of a loop where the condition begins
  NameId variable = 0;             // of #for
  double end = 0, step = 1;
  bool last_turn = false;          // an error was found inside: a loop ends with this turn
};

class TokenStream {
 public:
  static constexpr std::size_t kMostConditionals = 199;
  static constexpr std::size_t kMostFiles = 32;

  explicit TokenStream(Session& session) : session_(session) {}

  // The processed stream.
  const Item& peek() {
    if (window_size_ == 0) fetch(true);
    return window_[0];
  }
  // The same between two statements: where the token or a directive in front of it begins is noted, for reading on behind an error.
  const Item& peek_statement();
  Item take();
  void put_back(Item item);  // in front of what comes next
  // Behind the `;` of a numeric #declare: one more is passed over, also where the macro or the file ends in front of it, but no
  // directive is executed for it.
  void pass_second_semicolon() {
    const TokenFrame& frame = frames.back();
    const TokenKind next = frame.cursor->kind;
    if (frame.cursor == frame.end || next == TokenKind::kSemicolon || next == TokenKind::kMore) look_for_semicolon();
  }
  // The token as written that comes next in the innermost frame is of this kind; nothing is executed for it.
  bool at_written(TokenKind kind);
  bool at_written(Word word);
  bool window_empty() const { return window_size_ == 0; }

  // Fetches the token behind an operand: directives in front of it run only where the expression began in a place that allows
  // them.
  void fetch_after_operand() {
    if (window_size_ == 0) fetch(after_operand_ok_);
  }
  // Gives a token that was fetched but not taken back to its frame.
  void unread();
  // The same, if nothing was executed for it that would be executed again: compiled code starts from an empty window.
  void unread_plain() {
    if (window_size_ == 1 && window_[0].subscripts == 0 && frames.back().cursor == window_[0].source + 1) unread();
  }
  // An expression has ended: so is a `#` that was fetched unexecuted.
  void return_hash() {
    if (window_size_ == 1 && window_[0].token.kind == TokenKind::kHash) unread();
  }
  // After an identifier was taken: a comma or `)` comes next. Looks ahead only if the text does not say.
  bool ends_argument();

  // Tokens without directives and macro calls, names resolved (an array element with its subscripts). The window must be empty.
  Item take_raw();
  Item peek_raw();  // the same without moving; array subscripts are not read

  // For code that jumps: frames and conditionals.
  std::vector<TokenFrame> frames;
  std::vector<Conditional> conditionals;
  void push_conditional(Conditional conditional);
  void pop_conditional();
  void enter_file(SourceFile& file);
  void enter_macro(MacroPtr macro);
  // For code that looks at tokens ahead of the cursor: the innermost frame's file has this many behind it then, or it is complete.
  void read_ahead(std::size_t tokens);
  void leave_macro();
  // A macro's body was read: its tokens stay when those around it are forgotten.
  void keep(const Macro& macro);
  // After an error: leaves frames and conditionals until no more than these are left; the window is emptied.
  void unwind(std::size_t frame_count, std::size_t conditional_count);

  // Inside a loop or a macro, where the same tokens may be read again.
  bool repeats() const { return repeating_ > 0; }
  // Counts executed directives, calls and frame changes.
  std::uint64_t events = 0;

  // The last token taken, for messages.
  std::uint32_t last_file = 0;
  const Token* last_token = nullptr;

  // While directives and subscripts are read in the middle of something else, that something's look-ahead is set aside.
  class Aside {
   public:
    Aside(TokenStream& stream, bool after_operand_ok);
    ~Aside();
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;

   private:
    TokenStream& stream_;
    Item window_[2];
    int window_size_;
    bool after_operand_ok_;
  };

  // Sets whether directives run behind operands, until the end of the scope.
  class AfterOperand {
   public:
    AfterOperand(TokenStream& stream, bool ok) : stream_(stream), before_(stream.after_operand_ok_) {
      stream.after_operand_ok_ = ok;
    }
    ~AfterOperand() { stream_.after_operand_ok_ = before_; }
    AfterOperand(const AfterOperand&) = delete;
    AfterOperand& operator=(const AfterOperand&) = delete;

   private:
    TokenStream& stream_;
    bool before_;
  };

 private:
  void fetch(bool directives_allowed);
  void settle();        // reads the next piece where a run of literals begins or goes on
  bool settle_once();
  void leave_run(TokenFrame& frame);
  void lex_on(SourceFile& file);
  void forget_passed(const Token* before);
  bool at_frame_end();  // handles the end of a macro's body or of an included file; false when there is a token to read
  void look_for_semicolon();
  void resolve(Item& item, bool read_subscripts);
  void warn_deprecated(Deprecation& deprecation, const Item& item);
  [[noreturn]] void fail_unreadable(const TokenFrame& frame);

  Session& session_;
  Tokens pieces_[2];  // of runs, in turn: what was read last may still be asked about
  Item window_[2];
  int window_size_ = 0;
  bool after_operand_ok_ = true;
  bool between_statements_ = false;
  int repeating_ = 0;
  friend class Aside;
};

}  // namespace lute
