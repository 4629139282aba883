// Tokens: 16 bytes each, one vector per file, none of which ever changes or moves (a file is lexed once; loops and macro bodies are
// ranges of it).
// Source: specification chapter 10 §1.2.
#pragma once

#include <cstdint>
#include <string_view>

#include "parser/lexer/word.hpp"

namespace lute {

enum class TokenKind : std::uint8_t {
  kEnd,         // end of file; its offset is the file's size
  kMore,        // stands behind the last token while the rest of a large file is not lexed yet
  kError,       // what the lexer could not read: `index` is an entry of SourceFile::errors
  kNumber,      // `number`
  kString,      // `index`: entry of SourceFile::strings, `\"` resolved, other escapes untouched
  kName,        // `index`: NameId of an identifier
  kWord,        // `word`
  kRun,         // a long run of literals that is read when it is needed: `index` is an entry of SourceFile::runs
  kIdentifier,  // made by the reader: a name that holds a value
  // Punctuation.
  kLeftBrace, kRightBrace, kLeftParen, kRightParen, kLeftSquare, kRightSquare,
  kLess, kGreater, kLessEqual, kGreaterEqual, kNotEqual, kEqual,
  kComma, kSemicolon, kColon, kQuestion, kPeriod,
  kPlus, kMinus, kStar, kSlash, kAnd, kOr, kExclamation, kHash,
  kOther,       // @ $ % ^ ~ ' \ and backquote: lexed, without use; `index` is the character
};

std::string_view name_of(TokenKind kind);  // as messages print it: "{", "float constant", "End of File", ...

struct Token {
  TokenKind kind = TokenKind::kEnd;
  Word word = Word::kNone;
  std::uint32_t offset = 0;  // in bytes from the start of its file
  union {
    double number = 0;
    std::uint32_t index;
  };
};
static_assert(sizeof(Token) == 16);

using NameId = std::uint32_t;

}  // namespace lute
