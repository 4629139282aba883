// String expressions: literals, identifiers and the functions that make strings. Source: specification chapter 10 §1.3, §8.4.
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "parser/expression/nesting.hpp"
#include "parser/expression/recorder.hpp"

namespace lute {

bool starts_string(const Item& item) {
  switch (item.token.kind) {
    case TokenKind::kString: return true;
    case TokenKind::kIdentifier: return item.slot->holds<String>();
    case TokenKind::kWord:
      switch (item.token.word) {
        case Word::kStr: case Word::kVstr: case Word::kConcat: case Word::kChr: case Word::kSubstr: case Word::kStrupr:
        case Word::kStrlwr: case Word::kDatetime: return true;
        default: return false;
      }
    default: return false;
  }
}

std::string format_float(double value, int length, int precision) {
  // %[0][width].[precision]f; what would not fit the reference's buffer is printed with %g.
  constexpr int kLongest = 254;
  const int width = std::min(std::abs(length), 10 * kLongest);
  const int digits = precision < 0 ? 6 : std::min(precision, 10 * kLongest);
  const auto print = [&](const char* format) {
    std::array<char, 4 * 10 * kLongest> text{};
    const int written = std::snprintf(text.data(), text.size(), format, width, digits, value);
    return std::string(text.data(), static_cast<std::size_t>(std::max(written, 0)));
  };
  const std::string fixed = print(length < 0 ? "%0*.*f" : "%*.*f");
  if (static_cast<int>(fixed.size()) <= kLongest) return fixed;
  const std::string general = print(length < 0 ? "%0*.*g" : "%*.*g");
  return static_cast<int>(general.size()) <= kLongest ? general : "<invalid>";
}

namespace {

std::u16string string_argument(Session& session) {
  std::u16string text = parse_string(session);
  session.reader.comma();
  return text;
}

double last_number(Session& session) { return float_argument(session, Level::kAdditive); }

double number_argument(Session& session) {
  const double value = last_number(session);
  session.reader.comma();
  return value;
}

std::u16string parse_str(Session& session) {
  const double value = number_argument(session);
  const int length = to_int32(number_argument(session));
  const int precision = to_int32(last_number(session));
  return from_bytes(format_float(value, length, precision));
}

std::u16string parse_vstr(Session& session) {
  const int count = std::clamp(to_int32(number_argument(session)), 2, 5);
  const Number value = evaluate(session, Level::kAdditive);
  session.reader.comma();
  const std::u16string separator = string_argument(session);
  const int length = to_int32(number_argument(session));
  const int precision = to_int32(last_number(session));
  std::u16string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += separator;
    text += from_bytes(format_float(i < value.count ? value.c[static_cast<std::size_t>(i)] : 0, length, precision));
  }
  return text;
}

std::u16string parse_concat(Session& session, bool file_name) {
  // The first argument of a concat that names a file has its escapes resolved nevertheless.
  std::u16string text = parse_string(session);
  constexpr std::size_t kMostUnits = 1u << 28;
  while (!session.reader.at(TokenKind::kRightParen)) {
    session.reader.comma();
    const std::u16string next = parse_string(session, file_name);
    if (text.size() + next.size() > kMostUnits) session.fail("The string is too long.", "limit-memory");
    session.resources.charge((text.size() + next.size()) * sizeof(char16_t));
    text.reserve(text.size() + next.size());
    text += next;
  }
  return text;
}

std::u16string parse_chr(Session& session) {
  const std::int32_t code = to_int32(float_argument(session, Level::kFull));
  if (code < 0 || code > 65535) session.fail("Value " + std::to_string(code) + " cannot be used in chr(...).", "chr");
  return std::u16string(code == 0 ? 0 : 1, static_cast<char16_t>(code));  // a 0 ends a string
}

std::u16string parse_substr(Session& session) {
  const std::u16string text = string_argument(session);
  const std::int64_t position = to_int32(number_argument(session));
  const std::int64_t count = to_int32(last_number(session));
  if (position < 0 || count < 0 || position + count - 1 > static_cast<std::int64_t>(text.size())) {
    session.fail("Illegal parameters in substr.", "substr");
  }
  if (position == 0) return {};
  return text.substr(static_cast<std::size_t>(position - 1), static_cast<std::size_t>(count));
}

std::u16string parse_datetime(Session& session) {
  const double days = number_argument(session);
  std::string format = "%Y-%m-%d %H:%M:%SZ";
  if (!session.reader.at(TokenKind::kRightParen)) format = to_bytes(session, parse_string(session));
  if (format.empty()) session.fail("Empty format string.", "datetime");
  if (format.size() > 200) session.fail("Format string too long.", "datetime");
  constexpr double kSecondsTo2000 = 946684800.0;
  const double seconds = std::floor(days * 86400.0 + kSecondsTo2000 + 0.5);
  const bool countable = std::abs(seconds) < 0x1p63;  // anything else is 1970 in the reference
  const std::time_t time = countable ? static_cast<std::time_t>(seconds) : 0;
  std::tm parts{};
  const bool has_date = gmtime_r(&time, &parts) != nullptr;
  constexpr int kFirst = 1400 - 1900, kLast = 9999 - 1900;  // as a tm counts
  if (!has_date || parts.tm_year < kFirst || parts.tm_year > kLast) {
    session.fail("Year is out of valid range: 1400..9999", "datetime");
  }
  for (std::size_t at = 0; (at = format.find('%', at)) != format.npos;) {  // no names of time zones
    const bool zone = at + 1 < format.size() && (format[at + 1] == 'Z' || format[at + 1] == 'z');
    if (zone)
      format.erase(at, 2);
    else
      at += 2;
  }
  std::array<char, 1024> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), format.c_str(), &parts);
  return from_bytes(std::string_view(text.data(), length));
}

std::u16string change_case(std::u16string text, bool upper) {
  for (char16_t& c : text) {
    if (c < 128) c = static_cast<char16_t>(upper ? std::toupper(c) : std::tolower(c));
  }
  return text;
}

}  // namespace

std::u16string parse_string(Session& session, bool file_name) {
  const Item item = session.stream.peek();
  if (!starts_string(item)) session.fail_expected("string expression", item);
  session.stream.take();
  if (item.is(TokenKind::kString)) {
    return decode_literal(session, session.files[item.file]->strings[item.token.index], !file_name);
  }
  if (item.is(TokenKind::kIdentifier)) {
    const String& text = *item.slot->get_if<String>();
    session.resources.charge(text->size() * sizeof(char16_t));
    return *text;
  }

  const Nesting nesting(session);
  const TokenStream::AfterOperand allowed(session.stream, true);
  open_call(session);
  std::u16string text;
  switch (item.word()) {
    case Word::kStr: text = parse_str(session); break;
    case Word::kVstr: text = parse_vstr(session); break;
    case Word::kConcat: text = parse_concat(session, file_name); break;
    case Word::kChr: text = parse_chr(session); break;
    case Word::kSubstr: text = parse_substr(session); break;
    case Word::kStrupr: text = change_case(parse_string(session), true); break;
    case Word::kStrlwr: text = change_case(parse_string(session), false); break;
    default: text = parse_datetime(session); break;
  }
  close_call(session);
  return text;
}

}  // namespace lute
