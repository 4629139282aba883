// The grammar of numeric expressions in Boost.Spirit X3, on a cursor over the live token stream; all binary levels are one
// climbing parser. Source: specification chapter 10 §7.1.
#include "parser/expression/expression.hpp"

#include <algorithm>

#include <boost/spirit/home/x3.hpp>

#include "parser/expression/climb.hpp"
#include "parser/expression/recorder.hpp"
#include "parser/session.hpp"

namespace lute {

namespace {

namespace x3 = boost::spirit::x3;

using Cursor = TokenCursor<Session>;

template <TokenKind kKind>
struct Tok : x3::parser<Tok<kKind>> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const&, C const&, R&, A&) const {
    if (!first->is(kKind)) return false;
    ++first;
    return true;
  }
};
template <TokenKind kKind>
constexpr Tok<kKind> tok{};

// A parser written as a function of the session: false if the next token does not begin it. Once it has taken a token it either
// succeeds or throws.
template <bool (*kParse)(Session&, Number&)>
struct Step : x3::parser<Step<kParse>> {
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const&, C const&, R&, A& attribute) const {
    return kParse(first.state(), attribute);
  }
};

// Inside parentheses directives run everywhere, also behind operands.
template <class P>
struct Freely : x3::unary_parser<P, Freely<P>> {
  using base_type = x3::unary_parser<P, Freely<P>>;
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  constexpr explicit Freely(P const& p) : base_type(p) {}
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    const TokenStream::AfterOperand allowed(first.state().stream, true);
    return this->subject.parse(first, last, context, rcontext, attribute);
  }
};
template <class P>
constexpr auto freely(P const& p) { return Freely<typename x3::extension::as_parser<P>::value_type>(x3::as_parser(p)); }

// 0: no binary operator. All of & and | are one level, and so are the comparisons.
int level_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::kAnd:
    case TokenKind::kOr: return 1;
    case TokenKind::kLess:
    case TokenKind::kLessEqual:
    case TokenKind::kEqual:
    case TokenKind::kNotEqual:
    case TokenKind::kGreaterEqual:
    case TokenKind::kGreater: return 2;
    case TokenKind::kPlus:
    case TokenKind::kMinus: return 3;
    case TokenKind::kStar:
    case TokenKind::kSlash: return 4;
    default: return 0;
  }
}

constexpr int kAdditiveLevel = 3;
constexpr int kMostComponents = 5;

// Operators of the scene language: applied at once, and recorded.
struct Operators {
  using Value = Number;
  static constexpr const char* kOperand = "numeric expression";
  static int level(TokenKind kind) { return level_of(kind); }
  static Number combine(Session& session, TokenKind op, const Number& left, const Number& right) {
    record_binary(session, op);
    return apply_binary(session, op, left, right);
  }
};

Number parse_nested(Session& session, Level level);

// number | constant | identifier | function call: what the next token alone decides.
bool parse_operand(Session& session, Number& result);

bool parse_vector(Session& session, Number& result) {
  TokenStream& stream = session.stream;
  if (!stream.peek().is(TokenKind::kLess)) return false;
  stream.take();
  const Nesting nesting(session);
  const TokenStream::AfterOperand allowed(stream, true);
  result = Number();
  result.count = 0;
  do {
    const Number part = promoted(session, parse_nested(session, Level::kAdditive), 1);
    // As in the reference, what follows the fifth without a comma takes its place.
    if (result.count == kMostComponents) stop_recording(session);
    result.count = std::min(result.count + 1, kMostComponents);
    result.c[static_cast<std::size_t>(result.count - 1)] = part.c[0];
    if (result.count < kMostComponents) session.reader.comma();
  } while (result.count < 2 || starts_number(stream.peek()));
  const Item& closing = stream.peek();
  if (!closing.is(TokenKind::kGreater)) session.fail_expected(">", closing);
  stream.take();
  record(session, {CodeOp::kVector, 0, static_cast<std::uint16_t>(result.count), 0});
  return true;
}

// What follows an operand: the next token is fetched under the rules of the place, then perhaps a member.
bool parse_member(Session& session, Number& value) {
  TokenStream& stream = session.stream;
  stream.fetch_after_operand();
  if (!stream.peek().is(TokenKind::kPeriod)) return true;
  stream.take();
  const std::optional<Member> member = member_of(stream.peek().word());
  if (!member) session.fail_expected("x, y, z or color component", stream.peek());
  stream.take();
  record(session, {CodeOp::kMember, static_cast<std::uint8_t>(*member), 0, 0});
  value = apply_member(session, value, *member);
  stream.fetch_after_operand();
  return true;
}

struct FullTag;
struct SumTag;
struct FactorTag;
const x3::rule<FullTag, Number> full = "expression";
const x3::rule<SumTag, Number> sum = "additive expression";
const x3::rule<FactorTag, Number> factor = "numeric expression";


// Signs and `!` in front of an operand, applied from the innermost out.
struct Prefixed : x3::parser<Prefixed> {
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    Session& session = first.state();
    const TokenKind sign = first->token.kind;
    if (sign != TokenKind::kPlus && sign != TokenKind::kMinus && sign != TokenKind::kExclamation) return false;
    const Nesting nesting(session);
    ++first;
    if (!factor.parse(first, last, context, rcontext, attribute)) session.fail_expected("numeric expression", *first);
    if (sign == TokenKind::kMinus) {
      record(session, {CodeOp::kNegate, 0, 0, 0});
      attribute = apply_negate(attribute);
    } else if (sign == TokenKind::kExclamation) {
      record(session, {CodeOp::kNot, 0, 0, 0});
      attribute = apply_not(attribute);
    }
    return true;
  }
};

// '(' full ')' with its bound on nesting.
struct Group : x3::parser<Group> {
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    if (!first->is(TokenKind::kLeftParen)) return false;
    const Nesting nesting(first.state());
    static const auto group = tok<TokenKind::kLeftParen> >> freely(full);
    if (!group.parse(first, last, context, rcontext, attribute)) first.state().fail_expected("numeric expression", *first);
    if (!first->is(TokenKind::kRightParen)) first.state().fail_expected(")", *first);
    ++first;
    return true;
  }
};

// `? full : full` behind a condition. All three are evaluated; the chosen branch keeps its own count of components.
struct Choice : x3::parser<Choice> {
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    if (!first->is(TokenKind::kQuestion)) return true;
    Session& session = first.state();
    const Nesting nesting(session);
    if (!attribute.is_float()) session.fail("Conditional must evaluate to a float.", "float-expected");
    ++first;
    Number yes, no;
    if (!full.parse(first, last, context, rcontext, yes)) session.fail_expected("numeric expression", *first);
    if (!first->is(TokenKind::kColon)) session.fail_expected(":", *first);
    ++first;
    if (!full.parse(first, last, context, rcontext, no)) session.fail_expected("numeric expression", *first);
    record(session, {CodeOp::kChoose, 0, 0, 0});
    attribute = is_true(attribute.c[0]) ? yes : no;
    return true;
  }
};

// An operand with what may follow it.
template <class P>
struct WithMember : x3::unary_parser<P, WithMember<P>> {
  using base_type = x3::unary_parser<P, WithMember<P>>;
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  constexpr explicit WithMember(P const& p) : base_type(p) {}
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    return this->subject.parse(first, last, context, rcontext, attribute) && parse_member(first.state(), attribute);
  }
};
template <class P>
constexpr auto with_member(P const& p) { return WithMember<typename x3::extension::as_parser<P>::value_type>(x3::as_parser(p)); }

// A value, then what depends on it (`? :`).
template <class P, class Q>
struct Then : x3::binary_parser<P, Q, Then<P, Q>> {
  using base_type = x3::binary_parser<P, Q, Then<P, Q>>;
  using attribute_type = Number;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  constexpr Then(P const& p, Q const& q) : base_type(p, q) {}
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    return this->left.parse(first, last, context, rcontext, attribute) &&
           this->right.parse(first, last, context, rcontext, attribute);
  }
};
template <class P, class Q>
constexpr auto then(P const& p, Q const& q) {
  return Then<typename x3::extension::as_parser<P>::value_type, typename x3::extension::as_parser<Q>::value_type>(
      x3::as_parser(p), x3::as_parser(q));
}

const auto primary = Step<parse_operand>{} | Group{} | Step<parse_vector>{};
const auto factor_def = Prefixed{} | with_member(primary);
const auto sum_def = climb<kAdditiveLevel, Operators>(factor);
const auto full_def = then(climb<1, Operators>(factor), Choice{});
BOOST_SPIRIT_DEFINE(full, sum, factor)

Number parse_nested(Session& session, Level level) {
  Cursor first(session);
  Number result;
  const Cursor last;
  const bool single = level == Level::kAdditive && session.language.version < kFirstVersionWithOperators;
  const bool found = level == Level::kFull ? x3::parse(first, last, full, result)
                     : single              ? x3::parse(first, last, factor, result)
                                           : x3::parse(first, last, sum, result);
  if (!found) session.fail_expected("numeric expression", session.stream.peek());
  return result;
}

bool parse_identifier(Session& session, Number& result) {
  const Item item = session.stream.take();
  if (item.slot->empty()) session.fail_at("Attempt to access uninitialized array element.", "uninitialized", item);
  if (const Number* number = item.slot->get_if<Number>()) {
    result = *number;
    if (item.subscripts > 0) {
      record(session, {CodeOp::kElement, 0, item.subscripts, item.token.index});
    } else {
      record(session, {CodeOp::kLoad, 0, 0, item.token.index});
    }
    return true;
  }
  return parse_call_of_value(session, item, result);
}

bool parse_operand(Session& session, Number& result) {
  const Item& next = session.stream.peek();
  switch (next.token.kind) {
    case TokenKind::kNumber:
      result = Number(next.token.number);
      record_constant(session, result);
      session.stream.take();
      return true;
    case TokenKind::kIdentifier: {
      if (starts_string(next)) return parse_string_comparison(session, result);
      const bool usable = next.slot->empty() || starts_number(next);
      return usable && parse_identifier(session, result);
    }
    case TokenKind::kString: return parse_string_comparison(session, result);
    case TokenKind::kWord:
      if (starts_string(next)) return parse_string_comparison(session, result);
      return parse_word_operand(session, next.token.word, result);
    default: return false;
  }
}

// A literal, alone: most of a mesh. What follows must not be able to go on with the expression or be a directive or macro.
bool ends_expression(TokenKind kind) {
  switch (kind) {
    case TokenKind::kComma:
    case TokenKind::kSemicolon:
    case TokenKind::kRightBrace:
    case TokenKind::kRightParen:
    case TokenKind::kRightSquare:
    case TokenKind::kLeftBrace:
    case TokenKind::kWord:
    case TokenKind::kNumber:
    case TokenKind::kString: return true;
    default: return false;
  }
}

// `n` or `-n` at `p`; moves p behind it.
bool literal(const Token*& p, double& value) {
  const bool negative = p->kind == TokenKind::kMinus;
  const Token* const number = p + (negative ? 1 : 0);
  if (number->kind != TokenKind::kNumber) return false;
  value = negative ? -number->number : number->number;
  p = number + 1;
  return true;
}

// The fast path: `n` and `<n, n, n>` of literals, read straight from the file's tokens. The frame's end is a token that ends it.
bool parse_literal(Session& session, Level level, Number& result) {
  TokenStream& stream = session.stream;
  if (!stream.window_empty()) return false;
  TokenFrame& frame = stream.frames.back();
  const Token* p = frame.cursor;
  if (p == frame.end) return false;
  if (p->kind == TokenKind::kLess) {
    ++p;
    result = Number();
    result.count = 0;
    for (;;) {
      if (result.count == kMostComponents || !literal(p, result.c[static_cast<std::size_t>(result.count)])) return false;
      ++result.count;
      if (p->kind == TokenKind::kComma) {
        ++p;
      } else if (p->kind == TokenKind::kGreater) {
        break;
      } else {
        return false;
      }
    }
    if (result.count < 2) return false;
    ++p;
    // A full expression may compare; `<` behind an additive one begins the next vector.
    if (!ends_expression(p->kind) && !(p->kind == TokenKind::kLess && level == Level::kAdditive)) return false;
  } else {
    result = Number();
    if (!literal(p, result.c[0])) return false;
    const bool next_vector = p->kind == TokenKind::kLess && level == Level::kAdditive;
    if (!ends_expression(p->kind) && !next_vector && p->kind != TokenKind::kGreater) return false;
    if (p->kind == TokenKind::kGreater && level != Level::kAdditive) return false;
  }
  if (p > frame.end) return false;
  stream.last_file = frame.file->index;
  stream.last_token = p - 1;
  frame.cursor = p;
  return true;
}

}  // namespace

Number evaluate(Session& session, Level level) {
  ExpressionState& state = session.expressions;
  TokenStream& stream = session.stream;
  if (state.nested) {
    const Nesting nesting(session);
    return parse_nested(session, level);
  }
  stream.unread_plain();
  Number result;
  if (parse_literal(session, level, result)) return result;
  if (run_compiled(session, level, result)) return result;

  const bool recording = begin_recording(session);
  state.nested = true;
  const std::uint64_t events = stream.events;
  result = parse_nested(session, level);
  state.nested = false;
  if (recording && state.recording && events == stream.events) end_recording(session, level);
  state.recording.reset();
  stream.return_hash();
  return result;
}

}  // namespace lute
