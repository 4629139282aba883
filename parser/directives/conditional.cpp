// #if #ifdef #ifndef #elseif #else #switch #case #range. Source: specification chapter 10 §4, §4.2.
#include <cmath>

#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"
#include "parser/value/array.hpp"

namespace lute {

namespace {

using Kind = Conditional::Kind;

// `( full expression )` of a directive; directives do not run behind its operands.
double parenthesised_number(Session& session) {
  open_paren(session);
  const TokenStream::AfterOperand no_directives(session.stream, false);
  const double value = session.reader.condition_number();
  close_paren(session);
  return value;
}

bool parenthesised_condition(Session& session) { return is_true(parenthesised_number(session)); }

void push(Session& session, Kind kind) {
  Conditional conditional;
  conditional.kind = kind;
  conditional.start = session.stream.last_token;
  session.stream.push_conditional(conditional);
}

// After a branch that is not taken: on to the first one that is, or behind the #end.
void find_branch(Session& session) {
  for (;;) {
    switch (skip(session, false)) {
      case Word::kEnd: session.stream.pop_conditional(); return;
      case Word::kElse: session.stream.conditionals.back().kind = Kind::kElse; return;
      case Word::kElseif:
        if (parenthesised_condition(session)) return;
        break;
      default: session.fail("Mis-matched '#case' or '#range'.", "mismatched-directive");
    }
  }
}

// The argument of #case or #range; true if it matches.
bool case_matches(Session& session, Word word, double value) {
  if (word == Word::kCase) return std::fabs(parenthesised_number(session) - value) < kEpsilon;
  open_paren(session);
  const TokenStream::AfterOperand no_directives(session.stream, false);
  const double low = session.reader.number();
  session.reader.comma();
  const double high = session.reader.number();
  close_paren(session);
  return value >= low && value <= high;
}

}  // namespace

void open_paren(Session& session) {
  const Item item = session.stream.take_raw();
  if (!item.is(TokenKind::kLeftParen)) session.fail_expected("(", item);
}

void close_paren(Session& session) {
  session.stream.fetch_after_operand();
  const Item& next = session.stream.peek();
  if (!next.is(TokenKind::kRightParen)) session.fail_expected(")", next);
  session.stream.take();
}

void begin_if(Session& session, bool condition) {
  push(session, Kind::kIf);
  if (!condition) find_branch(session);
}

void run_if(Session& session) {
  const Token* const word = session.stream.last_token;
  const bool condition = parenthesised_condition(session);
  KnownDirective known;
  known.word = Word::kIf;
  remember_directive(session, word - 1, known, word + 2, TokenKind::kRightParen);
  begin_if(session, condition);
}

bool is_defined(Session& session) {
  const Item name = session.stream.take_raw();
  if (!name.is(TokenKind::kIdentifier)) return false;  // whatever it is: also a number or a string
  const WrittenElement element = written_element(session, name);
  return element.array ? element.array->elements.has_value(element.index) : !name.slot->empty();
}

void run_ifdef(Session& session, bool wanted) {
  open_paren(session);
  const bool defined = is_defined(session);
  close_paren(session);
  begin_if(session, defined == wanted);
}

void run_elseif(Session& session) {
  TokenStream& stream = session.stream;
  if (stream.conditionals.empty() || stream.conditionals.back().kind != Kind::kIf) {
    session.fail("Mis-matched '#elseif'.", "mismatched-directive");
  }
  skip(session, true);
  stream.pop_conditional();
}

void run_else(Session& session) {
  TokenStream& stream = session.stream;
  if (!stream.conditionals.empty() && stream.conditionals.back().kind == Kind::kSwitch) return;  // falling through
  if (stream.conditionals.empty() || stream.conditionals.back().kind != Kind::kIf) {
    session.fail("Mis-matched '#else'.", "mismatched-directive");
  }
  skip(session, true);
  stream.pop_conditional();
}

namespace {

// Between #switch and its first #case or #range, whose keyword is returned: directives and macros are executed, but nothing may be left
// of them.
Word run_switch_head(Session& session) {
  TokenStream& stream = session.stream;
  push(session, Kind::kSwitchHead);
  const std::size_t depth = stream.conditionals.size();
  for (;;) {
    const Item next = stream.peek_raw();
    if (next.is(TokenKind::kHash)) {
      const Token* const keyword = next.source + 1;
      const Word word = keyword->kind == TokenKind::kWord ? keyword->word : Word::kNone;
      if (stream.conditionals.size() > depth || (word != Word::kCase && word != Word::kRange)) {
        run_directive(session);
        continue;
      }
      stream.take_raw();
      stream.take_raw();
      stream.conditionals.back().kind = Kind::kSwitch;
      return word;
    }
    const MacroPtr* const macro = next.slot ? next.slot->get_if<MacroPtr>() : nullptr;
    stream.take_raw();
    if (macro == nullptr) session.fail_at("#switch not followed by #case or #range.", "switch-without-case", next);
    call_macro(session, MacroPtr(*macro), next);
  }
}

}  // namespace

void run_switch(Session& session) {
  TokenStream& stream = session.stream;
  const double value = parenthesised_number(session);
  Word word = run_switch_head(session);
  for (;;) {
    switch (word) {
      case Word::kCase:
      case Word::kRange:
        if (case_matches(session, word, value)) return;
        break;
      case Word::kElse: return;
      case Word::kEnd: stream.pop_conditional(); return;
      default: session.fail("Mis-matched '#elseif'.", "mismatched-directive");
    }
    word = skip(session, false);
  }
}

// Met while a branch is executed: it falls through, the argument is evaluated all the same.
void run_case(Session& session, Word word) {
  TokenStream& stream = session.stream;
  if (stream.conditionals.empty() || stream.conditionals.back().kind != Kind::kSwitch) {
    session.fail("Mis-matched '#case' or '#range'.", "mismatched-directive");
  }
  case_matches(session, word, 0);
}

}  // namespace lute
