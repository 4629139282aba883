// #while #for #end #break. A loop's tokens are read again from memory; nothing is lexed twice.
// Source: specification chapter 10 §4, §4.1, §4.3.
#include <cmath>

#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace {

using Kind = Conditional::Kind;

bool while_condition(Session& session) {
  open_paren(session);
  const TokenStream::AfterOperand no_directives(session.stream, false);
  const double value = session.reader.condition_number();
  close_paren(session);
  return is_true(value);
}

// The next turn of the #while on top of the stack; the cursor is behind its #end.
void repeat_while(Session& session) {
  TokenStream& stream = session.stream;
  if (stream.conditionals.back().last_turn) {
    stream.pop_conditional();
    return;
  }
  const Token* const behind = stream.frames.back().cursor;
  stream.frames.back().cursor = stream.conditionals.back().start;
  ++stream.events;
  session.resources.count_turn();
  if (while_condition(session)) return;
  stream.frames.back().cursor = behind;
  stream.pop_conditional();
}

}  // namespace

// `start` is where the body begins.
void repeat_for(Session& session) {
  TokenStream& stream = session.stream;
  const Conditional& loop = stream.conditionals.back();
  if (loop.last_turn) {
    stream.pop_conditional();
    return;
  }
  SymbolTable::Entry* entry = session.symbols.find_in_newest(loop.variable);
  const Number* value = entry != nullptr ? entry->slot->get_if<Number>() : nullptr;
  if (value == nullptr || !value->is_float()) {
    session.fail("#for loop variable must remain defined and numerical during loop.", "loop-variable");
  }
  const double next = value->c[0] + loop.step;
  *entry->slot = Number(next);
  ++stream.events;
  session.resources.count_turn();
  if (loop.step > 0 ? next > loop.end + kEpsilon : next < loop.end - kEpsilon) {
    stream.pop_conditional();
    return;
  }
  stream.frames.back().cursor = loop.start;
}

void run_while(Session& session) {
  TokenStream& stream = session.stream;
  Conditional loop;
  loop.kind = Kind::kWhile;
  loop.start = stream.frames.back().cursor;
  stream.push_conditional(loop);  // first, so that its condition is compiled
  const bool enters = while_condition(session);
  KnownDirective known;
  known.word = Word::kWhile;
  remember_directive(session, loop.start, known, loop.start + 1, TokenKind::kRightParen);
  if (enters) return;
  skip(session, true);
  stream.pop_conditional();
}

void run_for(Session& session) {
  TokenStream& stream = session.stream;
  Reader& reader = session.reader;
  open_paren(session);
  const Item name = stream.take_raw();
  const bool names_file = name.slot && name.slot->holds<UserFilePtr>();
  if (names_file || (!name.is(TokenKind::kName) && !name.is(TokenKind::kIdentifier))) session.fail_expected("undeclared identifier", name);
  if (stream.peek_raw().is(TokenKind::kLeftSquare)) {
    session.fail("#for loop variable must not be an array element", "loop-variable");
  }
  reader.comma();
  const double start = reader.number();
  reader.comma();
  Conditional loop;
  loop.kind = Kind::kFor;
  loop.variable = name.token.index;
  loop.end = reader.number();
  reader.comma();
  if (!reader.at(TokenKind::kRightParen)) loop.step = reader.number();
  close_paren(session);
  if (std::fabs(loop.step) < kEpsilon) session.fail("#for loop increment must be non-zero.", "loop-increment");

  if (SymbolTable::Entry* entry = session.symbols.find_in_newest(loop.variable)) {
    *entry->slot = Number(start);
  } else {
    session.symbols.add(loop.variable, session.symbols.newest(), std::make_shared<Value>(Number(start)));
  }
  loop.start = stream.frames.back().cursor;
  stream.push_conditional(loop);
  if (loop.step > 0 ? start < loop.end + kEpsilon : start > loop.end - kEpsilon) return;
  skip(session, true);
  stream.pop_conditional();
}

void run_end(Session& session) {
  TokenStream& stream = session.stream;
  const Kind kind = stream.conditionals.empty() ? Kind::kMacro : stream.conditionals.back().kind;
  if (kind == Kind::kMacro || kind == Kind::kSwitchHead) session.fail("Mis-matched '#end'.", "mismatched-directive");
  const Conditional& open = stream.conditionals.back();
  const bool loop = open.kind == Kind::kWhile || open.kind == Kind::kFor;
  if (!loop) {
    stream.pop_conditional();
    return;
  }
  if (open.frame + 1 != stream.frames.size()) {
    session.fail(open.kind == Kind::kWhile ? "#while loop did not end in file where it started."
                                           : "#for loop did not end in file where it started.",
                 "loop-across-files");
  }
  if (open.kind == Kind::kWhile) {
    repeat_while(session);
  } else {
    repeat_for(session);
  }
}

void run_break(Session& session) {
  TokenStream& stream = session.stream;
  bool breakable = false;
  for (const Conditional& open : stream.conditionals) breakable |= open.kind != Kind::kIf && open.kind != Kind::kElse;
  if (!breakable) session.fail("Invalid context for #break", "break-context");
  for (;;) {
    const Kind kind = stream.conditionals.back().kind;
    if (kind == Kind::kMacro) {
      // An early return: files that the body has included are left as well.
      while (stream.frames.size() > stream.conditionals.back().frame + 1u) {
        stream.frames.pop_back();
        session.symbols.pop_table();
      }
      stream.frames.back().cursor = stream.frames.back().end;
      return;
    }
    skip(session, true);
    if (kind == Kind::kSwitchHead) session.fail("Mis-matched '#end'.", "mismatched-directive");
    stream.pop_conditional();
    if (kind != Kind::kIf && kind != Kind::kElse) return;
  }
}

}  // namespace lute
