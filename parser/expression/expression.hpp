// Numeric, colour and string expressions. Operands take their values while they are read: a directive in the middle of an
// expression sees and changes what stands to its right only. Source: specification chapter 10 §7-§9.
#pragma once

#include <cmath>
#include <string>

#include "engine/math/vec.hpp"
#include "parser/expression/code.hpp"
#include "parser/reader.hpp"

namespace lute {

inline bool is_true(double value) { return std::fabs(value) > kEpsilon; }

// One expression, not yet promoted to what its place needs.
Number evaluate(Session& session, Level level);

// A value with more components than wanted is an error; with fewer it is promoted: a float to all components, else zeros.
Number promoted(Session& session, Number value, int components);

// The next token starts a numeric expression.
bool starts_number(const Item& item);

// Operators and functions on values, for the parser and for compiled code alike.
Number apply_binary(Session& session, TokenKind op, Number a, Number b);
Number apply_negate(Number a);
Number apply_not(Number a);
enum class Member : std::uint8_t { kFirst, kSecond, kThird, kFourth, kFifth, kGray };
std::optional<Member> member_of(Word word);
Number apply_member(Session& session, Number a, Member member);

// Functions whose arguments are numbers only. Their arguments in order: 'f' full, 'a' additive float, 'V' vector; a trailing '+'
// repeats the last, a trailing '?' makes it optional. Empty: no such function.
std::string_view numeric_signature(Word word);
Number apply_function(Session& session, Word word, std::span<const Number> arguments);
double apply_float_function(Session& session, Word word, std::span<const double> arguments);  // of those without a 'V'

// Functions that take names or strings: strlen, defined, trace, ... The keyword was taken. False if `word` is none of them.
bool parse_special_function(Session& session, Word word, Number& result);

// Strings. A literal used as a file name keeps its backslashes.
std::u16string parse_string(Session& session, bool file_name = false);
bool starts_string(const Item& item);
std::u16string decode_literal(Session& session, const std::string& raw, bool escapes);
std::u16string from_bytes(std::string_view text);            // one unit per byte
std::string to_bytes(const Session& session, const std::u16string& text);  // a byte stream: codes above 127 become blanks
std::string to_utf8(const std::u16string& text);
std::string format_float(double value, int length, int precision);

// Colours.
struct ColorValue {
  Color color;
  bool empty = false;  // no part at all was written
};
ColorValue parse_color(Session& session, int bare_components);
bool starts_color(const Item& item);
bool is_written_color(const Item& item);  // begins a colour that is no plain number or vector

// `spline { ... }`, the keyword was taken.
SplinePtr parse_spline(Session& session);
std::optional<SplineKind> spline_kind(Word word);

// What may stand behind the keyword `function`.
enum class FunctionForm : std::uint8_t {
  kDeclared,    // [(parameters)] { body }
  kBody,        // { body }
  kExpression,  // { expression }
};

// The keyword was taken.
FunctionPtr parse_function(Session& session, FunctionForm form);

std::int32_t to_int32(double value);  // truncated; out of range -2147483648

}  // namespace lute
