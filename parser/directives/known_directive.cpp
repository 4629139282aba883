#include "parser/directives/known_directive.hpp"

#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"

namespace lute {

namespace {

using Kind = Conditional::Kind;

bool is_macro(Session& session, const Token& token) {
  if (token.kind != TokenKind::kName) return false;
  const Value* const value = session.symbols.find_value(token.index);
  return value != nullptr && value->holds<MacroPtr>();
}

void take_known(Session& session, const KnownDirective& known) {
  TokenStream& stream = session.stream;
  ++stream.events;
  session.expressions.recording.reset();
  stream.last_file = stream.frames.back().file->index;
  stream.last_token = known.next - 1;
  stream.frames.back().cursor = known.next;
}

// A name that holds a number, or one that #local makes.
bool run_declaration(Session& session, const KnownDirective& known, Code& code) {
  const bool local = known.word == Word::kLocal;
  SymbolTable::Entry* entry = local ? session.symbols.find_in_newest(known.name) : session.symbols.find(known.name);
  if (entry == nullptr && !local) return false;
  if (entry != nullptr && !entry->slot->holds<Number>()) return false;
  Number value;
  if (double scalar = 0; code.scalar && run_scalar(session, *code.scalar, scalar)) {
    value = Number(scalar);
  } else if (!run(session, code, value)) {
    return false;
  }
  if (value.count == 5) value = Number(value.color());
  if (entry != nullptr) {
    *entry->slot = value;
  } else {
    session.symbols.add(known.name, session.symbols.newest(), std::make_shared<Value>(value));
  }
  take_known(session, known);
  session.stream.pass_second_semicolon();
  return true;
}

bool run_condition(Session& session, const KnownDirective& known, Code& code) {
  double value = 0;
  if (!code.scalar || !run_scalar(session, *code.scalar, value)) return false;
  take_known(session, known);
  if (is_true(value)) {
    begin_if(session, true);
    return true;
  }
  // Further conditions are read like those of any directive.
  const TokenStream::Aside aside(session.stream, true);
  const ExpressionState::Interruption interruption(session.expressions);
  begin_if(session, false);
  session.stream.unread();
  return true;
}

// `#end` of an #if or of a loop whose condition is known.
bool run_known_end(Session& session, const Token* hash) {
  TokenStream& stream = session.stream;
  if (stream.conditionals.empty()) return false;
  const Conditional& open = stream.conditionals.back();
  if (open.kind == Kind::kMacro || open.frame + 1 != stream.frames.size()) return false;
  TokenFrame& frame = stream.frames.back();
  if (open.kind == Kind::kWhile) {
    if (open.last_turn || open.start == frame.end) return false;
    const std::uint32_t index = frame.file->code_at(open.start);
    if (index == 0) return false;
    const KnownDirective& known = session.expressions.directives[index];
    Code& code = session.expressions.codes[known.code];
    double value = 0;
    if (!code.scalar || !run_scalar(session, *code.scalar, value)) return false;
    session.resources.count_turn();
    if (is_true(value)) {
      take_known(session, known);
      return true;
    }
  }
  ++stream.events;
  session.expressions.recording.reset();
  stream.last_file = frame.file->index;
  stream.last_token = hash + 1;
  frame.cursor = hash + 2;
  if (open.kind == Kind::kFor) {
    repeat_for(session);
  } else {
    stream.pop_conditional();
  }
  return true;
}

}  // namespace

bool run_known_directive(Session& session) {
  TokenStream& stream = session.stream;
  const TokenFrame& frame = stream.frames.back();
  if (frame.in_run()) return false;
  const Token* const hash = frame.cursor;
  if (hash + 1 == frame.end || hash[1].kind != TokenKind::kWord) return false;
  const Word word = hash[1].word;
  if (word == Word::kEnd) return run_known_end(session, hash);
  if (word != Word::kDeclare && word != Word::kLocal && word != Word::kIf) return false;
  const std::uint32_t index = frame.file->code_at(hash);
  if (index == 0) return false;
  const KnownDirective& known = session.expressions.directives[index];
  Code& code = session.expressions.codes[known.code];
  stream.last_file = frame.file->index;
  stream.last_token = code.begin;
  return word == Word::kIf ? run_condition(session, known, code) : run_declaration(session, known, code);
}

void remember_directive(Session& session, const Token* hash, KnownDirective directive, const Token* expression, TokenKind end) {
  const TokenStream& stream = session.stream;
  SourceFile& file = *stream.frames.back().file;
  const auto in_file = [&](const Token* token) {
    return token >= file.tokens.data() && token < file.tokens.data() + file.tokens.size();
  };
  if (!stream.repeats() || !in_file(hash) || !in_file(expression)) return;
  if (hash->kind != (directive.word == Word::kWhile ? TokenKind::kLeftParen : TokenKind::kHash)) return;
  const Level level = directive.word == Word::kDeclare || directive.word == Word::kLocal ? Level::kAdditive : Level::kFull;
  std::uint32_t code = file.code_at(expression);
  while (code != 0 && session.expressions.codes[code].level != level) code = session.expressions.codes[code].next;
  if (code == 0 || session.expressions.codes[code].end->kind != end || is_macro(session, *expression)) return;
  directive.code = code;
  directive.next = session.expressions.codes[code].end + 1;
  std::uint32_t& entry = file.expression_codes[file.token_index(hash)];
  if (entry != 0) return;
  entry = static_cast<std::uint32_t>(session.expressions.directives.size());
  session.expressions.directives.push_back(directive);
}

}  // namespace lute
