// Directives that were executed before, in loops and macros: what they are and where their expressions and their ends lie is
// remembered by their first token, so that the next turn goes straight to the value.
#pragma once

#include <cstdint>

#include "parser/lexer/token.hpp"

namespace lute {

struct Session;

struct KnownDirective {
  Word word = Word::kNone;      // declare, local, if or while
  NameId name = 0;              // of declare and local
  std::uint32_t code = 0;       // of the expression
  const Token* next = nullptr;  // behind the directive
};

// Executes the directive whose `#` is the innermost frame's next token, if it is known and nothing has changed that it depends
// on. False: nothing has happened.
bool run_known_directive(Session& session);

// Remembers a directive that was just executed: its `#`, and the expression that begins at `expression` and must end at a token of
// kind `end`. Does nothing if the expression was not compiled.
void remember_directive(Session& session, const Token* hash, KnownDirective directive, const Token* expression, TokenKind end);

}  // namespace lute
