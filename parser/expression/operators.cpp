// Operators on values of 1 to 5 components, and promotion. Source: specification chapter 10 §7.2-§7.4.
#include <limits>

#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

std::int32_t to_int32(double value) {
  if (!(value > -2147483649.0 && value < 2147483648.0)) return std::numeric_limits<std::int32_t>::min();
  return static_cast<std::int32_t>(value);
}

Number promoted(Session& session, Number value, int components) {
  if (value.count == components) return value;
  if (value.count > components) {
    switch (components) {
      case 1: session.fail("Float expected but vector or color expression found.", "float-expected");
      case 2: session.fail("UV_Vector expected but vector or color expression found.", "vector-expected");
      default: session.fail("Vector expected but color expression found.", "vector-expected");
    }
  }
  if (value.count == 1) value.c.fill(value.c[0]);
  // Components beyond the count are zero, also those that a replicated float has just written.
  for (std::size_t i = static_cast<std::size_t>(components); i < 5; ++i) value.c[i] = 0;
  value.count = components;
  return value;
}

namespace {

void extend(Number& value, int count) {
  if (value.count == 1) {
    for (std::size_t i = 1; i < static_cast<std::size_t>(count); ++i) value.c[i] = value.c[0];
  }
  value.count = count;
}

double compute(Session& session, TokenKind op, double a, double b) {
  switch (op) {
    case TokenKind::kPlus: return a + b;
    case TokenKind::kMinus: return a - b;
    case TokenKind::kStar: return a * b;
    case TokenKind::kSlash:
      if (b != 0) return a / b;
      session.warn("Divide by zero.", "divide-by-zero");
      return std::numeric_limits<double>::infinity();  // whatever the numerator is
    case TokenKind::kLess: return a < b ? 1 : 0;
    case TokenKind::kGreater: return a > b ? 1 : 0;
    case TokenKind::kLessEqual: return a <= b || std::fabs(a - b) <= kEpsilon ? 1 : 0;
    case TokenKind::kGreaterEqual: return a >= b || std::fabs(a - b) <= kEpsilon ? 1 : 0;
    case TokenKind::kEqual: return std::fabs(a - b) <= kEpsilon ? 1 : 0;
    case TokenKind::kNotEqual: return std::fabs(a - b) > kEpsilon ? 1 : 0;
    case TokenKind::kAnd: return is_true(a) && is_true(b) ? 1 : 0;
    case TokenKind::kOr: return is_true(a) || is_true(b) ? 1 : 0;
    default: return 0;
  }
}

}  // namespace

Number apply_binary(Session& session, TokenKind op, Number a, Number b) {
  if (a.count != b.count) {
    const int count = std::max(a.count, b.count);
    extend(a, count);
    extend(b, count);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) a.c[i] = compute(session, op, a.c[i], b.c[i]);
  return a;
}

Number apply_negate(Number a) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) a.c[i] = -a.c[i];
  return a;
}

Number apply_not(Number a) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) a.c[i] = is_true(a.c[i]) ? 0 : 1;
  return a;
}

std::optional<Member> member_of(Word word) {
  switch (word) {
    case Word::kX:
    case Word::kU:
    case Word::kRed: return Member::kFirst;
    case Word::kY:
    case Word::kV:
    case Word::kGreen: return Member::kSecond;
    case Word::kZ:
    case Word::kBlue: return Member::kThird;
    case Word::kT:
    case Word::kFilter: return Member::kFourth;
    case Word::kTransmit: return Member::kFifth;
    case Word::kGray: return Member::kGray;
    default: return std::nullopt;
  }
}

Number apply_member(Session& session, Number a, Member member) {
  if (member == Member::kGray) return Number(0.297 * a.c[0] + 0.589 * a.c[1] + 0.114 * a.c[2]);
  if (static_cast<int>(member) >= a.count) session.fail("Bad operands for period operator.", "member");
  return Number(a.c[static_cast<std::size_t>(member)]);
}

}  // namespace lute
