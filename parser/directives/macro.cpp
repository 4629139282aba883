// #macro and the calls of macros. A call reads the body's tokens in place of itself; numeric identifiers that stand alone as
// arguments are passed by reference. Source: specification chapter 10 §5.
#include "parser/directives/macro.hpp"

#include "parser/directives/directive.hpp"
#include "parser/expression/nesting.hpp"

namespace lute {

namespace {

constexpr std::size_t kMostParameters = 55;

// Parameter lists are kept short, so that a linear search for duplicates is no cost.
std::vector<NameId> parse_parameters(Session& session) {
  TokenStream& stream = session.stream;
  std::vector<NameId> parameters;
  for (;;) {
    const Item item = stream.take_raw();
    if (item.is(TokenKind::kRightParen)) return parameters;
    if (!item.is(TokenKind::kName) && !item.is(TokenKind::kIdentifier)) session.fail_expected("parameter identifier", item);
    if (parameters.size() >= kMostParameters) session.fail("Too many parameters", "macro-parameters");
    parameters.push_back(item.token.index);
    if (stream.peek_raw().is(TokenKind::kComma)) stream.take_raw();
  }
}

// "Ball(P, R)", for messages about calls.
std::string call_form(const Session& session, const Macro& macro) {
  std::string form(session.names.text(macro.name));
  for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
    form += i == 0 ? "(" : ", ";
    form += session.names.text(macro.parameters[i]);
  }
  return form + (macro.parameters.empty() ? "()" : ")");
}

void close_arguments(Session& session, const Macro& macro) {
  const Item& next = session.reader.peek();
  if (!next.is(TokenKind::kRightParen)) {
    Diagnostic d = session.diagnose(Severity::kError, "expected-token", "Expected ')', " + printed_name(session, next) + " found instead",
                                    next.file, next.source);
    d.hint = "the macro is called as " + call_form(session, macro);
    session.report_fatal(std::move(d));
  }
  close_paren(session);
}

[[noreturn]] void fail_argument_missing(Session& session, const Macro& macro, std::size_t found) {
  const Item& next = session.reader.peek();
  const std::string wanted = std::to_string(macro.parameters.size());
  Diagnostic d = session.diagnose(Severity::kError, "macro-arguments",
                                  "Expected " + wanted + " parameters but only " + std::to_string(found) + " found.", next.file, next.source);
  d.hint = "the macro is called as " + call_form(session, macro);
  session.report_fatal(std::move(d));
}

}  // namespace

void run_macro(Session& session) {
  TokenStream& stream = session.stream;
  const Token* const keyword = stream.last_token;
  if (session.language.version < 310) {
    char text[96];
    std::snprintf(text, sizeof text, "Macros require #version 3.1 or later but #version %.2f is set.",
                  session.language.version / 100.0);
    session.fail(text, "version");
  }
  const Item name = stream.take_raw();
  const bool free = name.is(TokenKind::kName) || (name.is(TokenKind::kIdentifier) && name.slot->holds<MacroPtr>());
  if (!free) session.fail_expected("undeclared identifier", name);
  open_paren(session);
  auto macro = std::make_shared<Macro>();
  macro->name = name.token.index;
  macro->parameters = parse_parameters(session);
  const std::size_t depth = stream.frames.size();
  macro->file = stream.frames.back().file;
  macro->begin = stream.frames.back().cursor;
  skip(session, true, keyword);
  if (stream.frames.size() != depth) session.fail("End of file reached but #end expected.", "missing-end");
  macro->end = stream.frames.back().cursor - 2;
  stream.keep(*macro);
  if (name.slot) {
    *name.slot = MacroPtr(macro);
  } else {
    session.symbols.add(macro->name, 0, std::make_shared<Value>(MacroPtr(macro)));
  }
}

void call_macro(Session& session, const MacroPtr& macro, const Item& name) {
  TokenStream& stream = session.stream;
  ++stream.events;
  stream.last_file = name.file;
  stream.last_token = name.source;
  std::vector<ParsedValue> arguments;
  arguments.reserve(macro->parameters.size());
  {
    const TokenStream::Aside aside(stream, true);
    const ExpressionState::Interruption interruption(session.expressions);
    const Nesting nesting(session);
    open_paren(session);
    for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
      // To the reference a file is no argument either: macros use its name.
      if (session.reader.at(TokenKind::kRightParen) || session.reader.at(Word::kT) || session.reader.at_identifier<UserFilePtr>()) {
        fail_argument_missing(session, *macro, i);
      }
      arguments.push_back(parse_value(session, ValueUse::kArgument));
      session.reader.comma();
    }
    close_arguments(session, *macro);
  }
  if (session.symbols.table_count() >= SymbolTable::kMostTables) {
    session.fail("Too many nested symbol tables", "nesting");
  }
  session.symbols.push_table();
  const std::uint32_t table = session.symbols.newest();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    // Of two parameters of one name the last counts.
    if (session.symbols.find_in_newest(macro->parameters[i]) != nullptr) session.symbols.remove(macro->parameters[i]);
    session.symbols.add(macro->parameters[i], table, std::move(arguments[i].slot)).depth = arguments[i].depth;
  }
  stream.enter_macro(macro);
}

}  // namespace lute
