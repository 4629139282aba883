// What the words behind `#` are: for the interpreter, for skipping, and for finding a place to read on after an error.
#pragma once

#include "parser/lexer/token.hpp"

namespace lute {

constexpr bool is_directive(Word word) {
  switch (word) {
    case Word::kDeclare: case Word::kLocal: case Word::kUndef: case Word::kIf: case Word::kIfdef: case Word::kIfndef:
    case Word::kElseif: case Word::kElse: case Word::kEnd: case Word::kWhile: case Word::kFor: case Word::kSwitch:
    case Word::kCase: case Word::kRange: case Word::kBreak: case Word::kMacro: case Word::kInclude: case Word::kVersion:
    case Word::kDefault: case Word::kDebug: case Word::kWarning: case Word::kError: case Word::kRender:
    case Word::kStatistics: case Word::kFopen: case Word::kFclose: case Word::kRead: case Word::kWrite: return true;
    default: return false;
  }
}
constexpr bool is_directive(const Token& token) { return token.kind == TokenKind::kWord && is_directive(token.word); }

// Ends with an #end of its own.
constexpr bool opens_region(Word word) {
  switch (word) {
    case Word::kIf:
    case Word::kIfdef:
    case Word::kIfndef:
    case Word::kWhile:
    case Word::kFor:
    case Word::kSwitch:
    case Word::kMacro: return true;
    default: return false;
  }
}

constexpr bool opens_region(const Token& token) { return token.kind == TokenKind::kWord && opens_region(token.word); }

// Begins another branch of the region it stands in.
constexpr bool selects_branch(Word word) {
  return word == Word::kElse || word == Word::kElseif || word == Word::kCase || word == Word::kRange;
}

}  // namespace lute
