// Text of string literals: escapes and character sets. Source: specification chapter 10 §1.3.
#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

std::u16string from_bytes(std::string_view text) {
  std::u16string result;
  result.reserve(text.size());
  for (const char c : text) result += static_cast<char16_t>(static_cast<unsigned char>(c));
  return result;
}

std::string to_bytes(const Session& session, const std::u16string& text) {
  std::string result;
  result.reserve(text.size());
  for (const char16_t c : text) {
    if (c < 128) {
      result += static_cast<char>(c);
    } else {
      result += session.language.version >= 350 ? ' ' : static_cast<char>(static_cast<unsigned char>(c & 0xFF));
    }
  }
  return result;
}

std::string to_utf8(const std::u16string& text) {
  std::string result;
  for (const char16_t c : text) {
    if (c < 0x80) {
      result += static_cast<char>(c);
    } else if (c < 0x800) {
      result += static_cast<char>(0xC0 | c >> 6);
      result += static_cast<char>(0x80 | (c & 0x3F));
    } else {
      result += static_cast<char>(0xE0 | c >> 12);
      result += static_cast<char>(0x80 | (c >> 6 & 0x3F));
      result += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
  return result;
}

namespace {

// One character above 127 of a literal, by the scene's character set. Moves `i` behind it.
char16_t decode_character(Session& session, const std::string& raw, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(raw[k])); };
  const unsigned lead = byte(i);
  if (session.language.charset == Reader::Charset::kSystem) {
    session.fail("Cannot convert system specific text format to Unicode.", "character");
  }
  if (session.language.charset != Reader::Charset::kUtf8) {
    ++i;
    if (session.language.version < 350) return static_cast<char16_t>(lead);
    session.possible_error("Non-ASCII character has been replaced by space character.", "character");
    return u' ';
  }
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  unsigned code = more == 3 ? lead & 7u : more == 2 ? lead & 15u : lead & 31u;
  ++i;
  bool valid = more > 0;
  for (int k = 0; k < more; ++k) {  // as in the reference the first byte says how many are taken, whatever they are
    const bool follows = i < raw.size() && (byte(i) & 0xC0) == 0x80;
    valid = valid && follows;
    if (follows) code = code << 6 | (byte(i) & 0x3F);
    if (i < raw.size()) ++i;
  }
  if (!valid || code > 0xFFFF) return 0xFFFD;
  return static_cast<char16_t>(code);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// The escape at `i` (its backslash); moves `i` behind it.
char16_t decode_escape(Session& session, const std::string& raw, std::size_t& i) {
  const auto illegal = [&] { session.fail("Illegal escape sequence in string.", "escape"); };
  if (i + 1 >= raw.size()) illegal();
  const char c = raw[i + 1];
  i += 2;
  switch (c) {
    case 'a': return 7;
    case 'b': return 8;
    case 'f': return 12;
    case 'n': return 10;
    case 'r': return 13;
    case 't': return 9;
    case 'v': return 11;
    case '\\':
    case '\'':
    case '"': return static_cast<char16_t>(c);
    case 'u': {
      if (i + 4 > raw.size()) session.fail("Unexpected end of escape sequence in text string.", "escape");
      int code = 0;
      for (int k = 0; k < 4; ++k, ++i) {
        const int digit = hex_digit(raw[i]);
        if (digit < 0) illegal();
        code = code * 16 + digit;
      }
      return static_cast<char16_t>(code);
    }
    default: illegal();
  }
  return 0;
}

}  // namespace

std::u16string decode_literal(Session& session, const std::string& raw, bool escapes) {
  std::u16string text;
  text.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size();) {
    if (static_cast<unsigned char>(raw[i]) > 127) {
      text += decode_character(session, raw, i);
    } else if (escapes && raw[i] == '\\') {
      text += decode_escape(session, raw, i);
    } else if (raw[i] == '\r' && i + 1 < raw.size() && raw[i + 1] == '\n') {
      ++i;  // a line end is one character, whatever system the file is from
    } else {
      text += static_cast<char16_t>(raw[i++]);
    }
  }
  if (const std::size_t end = text.find(u'\0'); end != text.npos) text.resize(end);  // as in the reference a 0 ends a string
  return text;
}

}  // namespace lute
