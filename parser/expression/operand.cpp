// Operands that begin with a reserved word or an identifier: constants, built-in functions, user functions, splines, strings
// that are compared. Source: specification chapter 10 §7.5, §8.
#include <chrono>

#include "parser/directives/directive.hpp"
#include "parser/expression/recorder.hpp"

namespace lute {

void open_call(Session& session) {
  const Item& next = session.stream.peek();
  if (!next.is(TokenKind::kLeftParen)) session.fail_expected("(", next);
  session.stream.take();
}

void close_call(Session& session) {
  const Item& next = session.stream.peek();
  if (!next.is(TokenKind::kRightParen)) session.fail_expected(")", next);
  session.stream.take();
}

double float_argument(Session& session, Level level) { return promoted(session, evaluate(session, level), 1).c[0]; }
dvec3 vector_argument(Session& session) { return promoted(session, evaluate(session, Level::kAdditive), 3).vector(); }

namespace {

// Days since 2000-01-01 00:00 UTC, to the microsecond.
double now_in_days() {
  using namespace std::chrono;
  constexpr double kSecondsTo2000 = 946684800.0;
  const auto microseconds_since_1970 = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
  return (static_cast<double>(microseconds_since_1970) / 1e6 - kSecondsTo2000) / 86400.0;
}

Number vector_of(std::initializer_list<double> components) {
  Number result;
  result.count = static_cast<int>(components.size());
  std::copy(components.begin(), components.end(), result.c.begin());
  return result;
}

std::optional<Number> constant(const Session& session, Word word) {
  switch (word) {
    case Word::kPiWord: return Number(kPi);
    case Word::kTrue:
    case Word::kYes:
    case Word::kOn: return Number(1.0);
    case Word::kFalse:
    case Word::kNo:
    case Word::kOff: return Number(0.0);
    case Word::kX: return vector_of({1, 0, 0});
    case Word::kY: return vector_of({0, 1, 0});
    case Word::kZ: return vector_of({0, 0, 1});
    case Word::kU: return vector_of({1, 0});
    case Word::kV: return vector_of({0, 1});
    case Word::kT: return vector_of({0, 0, 0, 1});
    case Word::kClock: return Number(static_cast<double>(static_cast<float>(session.options.clock)));
    case Word::kClockOn: return Number(session.options.clock_on ? 1.0 : 0.0);
    default: return std::nullopt;
  }
}

bool is_constant(Word word) {
  switch (word) {
    case Word::kPiWord: case Word::kTrue: case Word::kYes: case Word::kOn: case Word::kFalse: case Word::kNo: case Word::kOff:
    case Word::kX: case Word::kY: case Word::kZ: case Word::kU: case Word::kV: case Word::kT: case Word::kClock:
    case Word::kClockOn: case Word::kVersion: case Word::kNow: return true;
    default: return false;
  }
}

bool is_special_function(Word word) {
  switch (word) {
    case Word::kAsc: case Word::kStrlen: case Word::kStrcmp: case Word::kVal: case Word::kFileExists: case Word::kDefined:
    case Word::kDimensions: case Word::kDimensionSize: case Word::kInside: case Word::kTrace: case Word::kMinExtent:
    case Word::kMaxExtent: return true;
    default: return false;
  }
}

// The keyword was taken.
Number parse_numeric_call(Session& session, Word word, std::string_view signature) {
  open_call(session);
  std::vector<Number> arguments;
  const bool repeated = signature.size() > 1 && signature[1] == '+';
  const bool optional_last = signature.back() == '?';
  const std::size_t most = repeated ? SIZE_MAX : signature.size() - (optional_last ? 1 : 0);
  const std::size_t least = repeated ? 1 : most - (optional_last ? 1 : 0);
  while (arguments.size() < most) {
    // Between arguments that must be there a comma may be missing; one that may be left out is announced by its comma.
    const bool required = arguments.size() < least;
    if (!arguments.empty() && !session.reader.accept(TokenKind::kComma) && !required) break;
    const char kind = repeated ? 'a' : signature[arguments.size()];
    const Number argument = evaluate(session, kind == 'f' ? Level::kFull : Level::kAdditive);
    // Checked at once: the message belongs to this argument.
    promoted(session, argument, kind == 'V' ? 3 : 1);
    arguments.push_back(argument);
  }
  if (word == Word::kVturbulence) session.reader.comma();  // which the reference lets pass here alone
  close_call(session);
  if (arguments.size() > 0xFFFF) {
    stop_recording(session);
  } else {
    record(session, {CodeOp::kCall, 0, static_cast<std::uint16_t>(arguments.size()), static_cast<std::uint32_t>(word)});
  }
  return apply_function(session, word, arguments);
}

}  // namespace

bool starts_number(const Item& item) {
  switch (item.token.kind) {
    case TokenKind::kNumber:
    case TokenKind::kLess:
    case TokenKind::kLeftParen:
    case TokenKind::kPlus:
    case TokenKind::kMinus:
    case TokenKind::kExclamation: return true;
    case TokenKind::kIdentifier:
      return item.slot->holds<Number>() || item.slot->holds<SplinePtr>() || item.slot->holds<FunctionPtr>();
    case TokenKind::kWord:
      return is_constant(item.token.word) || is_special_function(item.token.word) || !numeric_signature(item.token.word).empty();
    default: return false;
  }
}

bool parse_word_operand(Session& session, Word word, Number& result) {
  TokenStream& stream = session.stream;
  if (const std::optional<Number> value = constant(session, word)) {
    stream.take();
    result = *value;
    record_constant(session, result);
    return true;
  }
  if (word == Word::kVersion) {
    stream.take();
    result = Number(session.language.version / 100.0);
    record(session, {CodeOp::kVersion, 0, 0, 0});
    return true;
  }
  if (word == Word::kNow) {
    stream.take();
    result = Number(now_in_days());
    stop_recording(session);
    return true;
  }
  const TokenStream::AfterOperand allowed(stream, true);
  if (const std::string_view signature = numeric_signature(word); !signature.empty()) {
    stream.take();
    result = parse_numeric_call(session, word, signature);
    return true;
  }
  if (!is_special_function(word)) return false;
  stream.take();
  return parse_special_function(session, word, result);
}

namespace {

Number call_spline(Session& session, const Item& item, const SplinePtr& spline) {
  open_call(session);
  const double t = float_argument(session, Level::kAdditive);
  std::optional<SplineKind> kind;
  if (session.reader.accept(TokenKind::kComma)) {
    kind = spline_kind(session.reader.word());
    if (!kind) session.fail("linear_spline, quadratic_spline, natural_spline, or cubic_spline expected.", "spline");
    session.reader.take();
  }
  close_call(session);
  if (item.subscripts > 0) {
    stop_recording(session);
  } else {
    const auto detail = static_cast<std::uint8_t>(kind ? 1 + static_cast<int>(*kind) : 0);
    record(session, {CodeOp::kSpline, detail, 0, item.token.index});
  }
  Number result;
  result.count = spline->components;
  result.c = kind ? spline->evaluate(t, *kind) : spline->evaluate(t);
  return result;
}

Number call_function(Session& session, const Item& item, const FunctionPtr& function) {
  open_call(session);
  std::vector<double> arguments;
  const auto count = static_cast<std::size_t>(function->parameter_count());
  for (std::size_t i = 0; i < count; ++i) {
    arguments.push_back(float_argument(session, Level::kAdditive));
    if (i + 1 < count) session.reader.comma();
  }
  close_call(session);
  if (item.subscripts > 0) {
    stop_recording(session);
  } else {
    record(session, {CodeOp::kUserFunction, 0, static_cast<std::uint16_t>(count), item.token.index});
  }
  Number result;
  result.count = function->result_count();
  function->evaluate(arguments.data(), result.c.data());
  return result;
}

}  // namespace

bool parse_call_of_value(Session& session, const Item& item, Number& result) {
  const TokenStream::AfterOperand allowed(session.stream, true);
  if (const SplinePtr* spline = item.slot->get_if<SplinePtr>()) {
    result = call_spline(session, item, SplinePtr(*spline));
    return true;
  }
  if (const FunctionPtr* function = item.slot->get_if<FunctionPtr>()) {
    result = call_function(session, item, FunctionPtr(*function));
    return true;
  }
  return false;
}

bool parse_string_comparison(Session& session, Number& result) {
  TokenStream& stream = session.stream;
  stop_recording(session);
  const std::u16string left = parse_string(session);
  stream.fetch_after_operand();
  const TokenKind op = stream.peek().token.kind;
  const auto value = [&](auto&& compare) {
    stream.take();
    result = Number(compare(left, parse_string(session)) ? 1.0 : 0.0);
    return true;
  };
  switch (op) {
    case TokenKind::kLess: return value(std::less<>{});
    case TokenKind::kLessEqual: return value(std::less_equal<>{});
    case TokenKind::kEqual: return value(std::equal_to<>{});
    case TokenKind::kNotEqual: return value(std::not_equal_to<>{});
    case TokenKind::kGreaterEqual: return value(std::greater_equal<>{});
    case TokenKind::kGreater: return value(std::greater<>{});
    default: session.fail_expected("string comparison operator", stream.peek());
  }
}

}  // namespace lute
