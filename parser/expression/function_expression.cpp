// The expression in function { }: it becomes a program. The grammar is X3's; unlike scene expressions, & binds tighter than |, and
// nothing is evaluated while it is read. Source: specification chapters 10 §11 and 21 §11.
#include <boost/spirit/home/x3.hpp>

#include "parser/expression/climb.hpp"
#include "parser/expression/expression.hpp"
#include "parser/expression/function_scope.hpp"

namespace lute {

namespace {

namespace x3 = boost::spirit::x3;
using Node = ExpressionBuilder::Node;

// The node in a type of its own: X3 would take a plain integer for a character.
struct NodeValue {
  Node node = 0;
};

constexpr std::size_t kMostOperators = 10'000;

struct FunctionOperators {
  using Value = NodeValue;
  static constexpr const char* kOperand = "operand";
  static int level(TokenKind kind) {
    switch (kind) {
      case TokenKind::kOr: return 1;
      case TokenKind::kAnd: return 2;
      case TokenKind::kLess:
      case TokenKind::kLessEqual:
      case TokenKind::kEqual:
      case TokenKind::kNotEqual:
      case TokenKind::kGreaterEqual:
      case TokenKind::kGreater: return 3;
      case TokenKind::kPlus:
      case TokenKind::kMinus: return 4;
      case TokenKind::kStar:
      case TokenKind::kSlash: return 5;
      default: return 0;
    }
  }
  static BinaryOp operation(TokenKind kind) {
    switch (kind) {
      case TokenKind::kOr: return BinaryOp::kOr;
      case TokenKind::kAnd: return BinaryOp::kAnd;
      case TokenKind::kLess: return BinaryOp::kLess;
      case TokenKind::kLessEqual: return BinaryOp::kLessEqual;
      case TokenKind::kEqual: return BinaryOp::kEqual;
      case TokenKind::kNotEqual: return BinaryOp::kNotEqual;
      case TokenKind::kGreaterEqual: return BinaryOp::kGreaterEqual;
      case TokenKind::kGreater: return BinaryOp::kGreater;
      case TokenKind::kPlus: return BinaryOp::kAdd;
      case TokenKind::kMinus: return BinaryOp::kSubtract;
      case TokenKind::kStar: return BinaryOp::kMultiply;
      default: return BinaryOp::kDivide;
    }
  }
  static NodeValue combine(FunctionScope& scope, TokenKind op, NodeValue left, NodeValue right) {
    // A chain of operators is a deep tree: bounded, so that whoever walks the tree has stack enough.
    if (++scope.operators > kMostOperators) scope.session.fail("The function is too long.", "nesting");
    return {scope.builder.binary(operation(op), left.node, right.node)};
  }
};

bool parse_function_operand(FunctionScope& scope, NodeValue& result);

struct FunctionOperand : x3::parser<FunctionOperand> {
  using attribute_type = NodeValue;
  static bool const has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const&, C const&, R&, A& attribute) const {
    return parse_function_operand(first.state(), attribute);
  }
};

struct FunctionExpressionTag;
struct FunctionFactorTag;
const x3::rule<FunctionExpressionTag, NodeValue> function_expression = "function expression";
const x3::rule<FunctionFactorTag, NodeValue> function_factor = "operand";

struct FunctionSign : x3::parser<FunctionSign> {
  using attribute_type = NodeValue;
  static bool const has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    const TokenKind sign = first->token.kind;
    if (sign != TokenKind::kPlus && sign != TokenKind::kMinus) return false;
    FunctionScope& scope = first.state();
    const Nesting nesting(scope.session);
    ++first;
    if (!function_factor.parse(first, last, context, rcontext, attribute)) {
      scope.session.fail_expected("operand", *first);
    }
    if (sign == TokenKind::kMinus) attribute.node = scope.builder.unary(UnaryOp::kNegate, attribute.node);
    return true;
  }
};

const auto function_factor_def = FunctionSign{} | FunctionOperand{};
const auto function_expression_def = climb<1, FunctionOperators>(function_factor);
BOOST_SPIRIT_DEFINE(function_factor, function_expression)

Node parse_expression(FunctionScope& scope) {
  const Nesting nesting(scope.session);
  TokenCursor<FunctionScope> first(scope);
  const TokenCursor<FunctionScope> last;
  NodeValue result;
  if (!x3::parse(first, last, function_expression, result)) {
    const Item& next = scope.session.stream.peek();
    scope.session.fail_expected(next.is(TokenKind::kExclamation) ? "sign or operand" : "operand", next);
  }
  return result.node;
}

// `( e, e, ... )`; commas are required here.
std::vector<Node> parse_arguments(FunctionScope& scope) {
  Reader& reader = scope.session.reader;
  std::vector<Node> arguments;
  reader.expect(TokenKind::kLeftParen);
  if (reader.accept(TokenKind::kRightParen)) return arguments;
  do {
    arguments.push_back(parse_expression(scope));
  } while (reader.accept(TokenKind::kComma));
  reader.expect(TokenKind::kRightParen);
  return arguments;
}

std::optional<UnaryOp> unary_function(Word word) {
  switch (word) {
    case Word::kSin: return UnaryOp::kSin;
    case Word::kCos: return UnaryOp::kCos;
    case Word::kTan: return UnaryOp::kTan;
    case Word::kAsin: return UnaryOp::kAsin;
    case Word::kAcos: return UnaryOp::kAcos;
    case Word::kAtan: return UnaryOp::kAtan;
    case Word::kSinh: return UnaryOp::kSinh;
    case Word::kCosh: return UnaryOp::kCosh;
    case Word::kTanh: return UnaryOp::kTanh;
    case Word::kAsinh: return UnaryOp::kAsinh;
    case Word::kAcosh: return UnaryOp::kAcosh;
    case Word::kAtanh: return UnaryOp::kAtanh;
    case Word::kAbs: return UnaryOp::kAbs;
    case Word::kRadians: return UnaryOp::kRadians;
    case Word::kDegrees: return UnaryOp::kDegrees;
    case Word::kFloor: return UnaryOp::kFloor;
    case Word::kCeil: return UnaryOp::kCeil;
    case Word::kInt: return UnaryOp::kInt;
    case Word::kSqrt: return UnaryOp::kSqrt;
    case Word::kExp: return UnaryOp::kExp;
    case Word::kLn: return UnaryOp::kLn;
    case Word::kLog: return UnaryOp::kLog;
    default: return std::nullopt;
  }
}

std::optional<BinaryOp> binary_function(Word word) {
  switch (word) {
    case Word::kAtan2: return BinaryOp::kAtan2;
    case Word::kMod: return BinaryOp::kMod;
    case Word::kPow: return BinaryOp::kPow;
    case Word::kDiv: return BinaryOp::kDiv;
    case Word::kMin: return BinaryOp::kMin;
    case Word::kMax: return BinaryOp::kMax;
    default: return std::nullopt;
  }
}

void check_count(FunctionScope& scope, std::size_t supplied, std::size_t required) {
  if (supplied == required) return;
  scope.session.fail("Invalid number of parameters: " + std::to_string(supplied) + " supplied, " + std::to_string(required) +
                         " required!",
                     "function-arguments");
}

[[noreturn]] void fail_count(FunctionScope& scope, Word word, const char* expected) {
  scope.session.fail("Invalid number of parameters for '" + std::string(spelling(word)) + "': " + expected + " expected!",
                     "function-arguments");
}

Node parse_built_in(FunctionScope& scope, Word word, UnaryOp op) {
  const std::vector<Node> arguments = parse_arguments(scope);
  if (arguments.size() != 1) fail_count(scope, word, "Only one parameter");
  return scope.builder.unary(op, arguments[0]);
}

Node parse_built_in(FunctionScope& scope, Word word, BinaryOp op) {
  const std::vector<Node> arguments = parse_arguments(scope);
  const bool any_number = word == Word::kMin || word == Word::kMax;
  if (any_number && arguments.size() < 2) fail_count(scope, word, "At least two parameters");
  if (!any_number && arguments.size() != 2) fail_count(scope, word, "Two parameters");
  Node result = arguments[0];
  for (std::size_t i = 1; i < arguments.size(); ++i) result = scope.builder.binary(op, result, arguments[i]);
  return result;
}

Node parse_select(FunctionScope& scope) {
  const std::vector<Node> a = parse_arguments(scope);
  if (a.size() != 3 && a.size() != 4) fail_count(scope, Word::kSelect, "Three or four parameters");
  return scope.builder.select(a[0], a[1], a[2], a.size() == 4 ? a[3] : a[2]);
}

// sum(i, from, to, term): `i` is a new name inside the term. A coordinate may stand there, but stays what it is.
Node parse_repetition(FunctionScope& scope, bool product) {
  Reader& reader = scope.session.reader;
  reader.expect(TokenKind::kLeftParen);
  const Item name = reader.peek();
  const bool runs = name.is(TokenKind::kName);
  if (!runs && !is_coordinate(name.word())) scope.session.fail_expected("undeclared identifier", name);
  reader.take();
  if (!runs) scope.session.warn("The variable of sum() or prod() needs a name of its own: a coordinate does not run.", "function");
  reader.expect(TokenKind::kComma);
  const Node from = parse_expression(scope);
  reader.expect(TokenKind::kComma);
  const Node to = parse_expression(scope);
  reader.expect(TokenKind::kComma);
  const Node local = scope.builder.local();
  if (runs) scope.locals.emplace_back(name.token.index, local);
  const Node term = parse_expression(scope);
  if (runs) scope.locals.pop_back();
  reader.expect(TokenKind::kRightParen);
  return product ? scope.builder.product(local, from, to, term) : scope.builder.sum(local, from, to, term);
}

// A component of a vector function's result.
Node parse_component(FunctionScope& scope, const FunctionPtr& function, std::span<const Node> arguments) {
  Session& session = scope.session;
  ExpressionBuilder& e = scope.builder;
  session.reader.expect(TokenKind::kPeriod);
  const Item item = session.stream.peek();
  const std::string_view name = item.is(TokenKind::kName) ? session.names.text(item.token.index) : std::string_view();
  const auto component = [&](unsigned k) { return e.call(function, arguments, k); };
  const auto scaled = [&](double weight, unsigned k) { return e.binary(BinaryOp::kMultiply, e.constant(weight), component(k)); };
  const std::optional<Member> member = member_of(item.word());
  if (!member && name != "grey" && name != "hf") session.fail_at("Invalid member access: Valid member names are x, y, z, t, u, v, red, green, blue, grey, filter and transmit.", "member", item);
  session.stream.take();
  if (name == "hf") {
    return e.binary(BinaryOp::kMultiply, e.constant(0.996093),
                    e.binary(BinaryOp::kAdd, component(0), e.binary(BinaryOp::kDivide, component(1), e.constant(255))));
  }
  if (!member || *member == Member::kGray) {
    return e.binary(BinaryOp::kAdd, e.binary(BinaryOp::kAdd, scaled(0.297, 0), scaled(0.589, 1)), scaled(0.114, 2));
  }
  if (static_cast<int>(*member) >= function->result_count()) session.fail("Bad operands for period operator.", "member");
  return component(static_cast<unsigned>(*member));
}

Node parse_function_call(FunctionScope& scope, const FunctionPtr& function) {
  const std::vector<Node> arguments = parse_arguments(scope);
  check_count(scope, arguments.size(), static_cast<std::size_t>(function->parameter_count()));
  if (function->is_vector()) return parse_component(scope, function, arguments);
  return scope.builder.call(function, arguments);
}

// x and u are one slot, y and v another; the last parameter of a slot counts, and a slot that none fills reads 0.
Node slot_of(FunctionScope& scope, Word word) {
  const auto slot = [](Word w) { return w == Word::kX || w == Word::kU ? 1 : w == Word::kY || w == Word::kV ? 2 : w == Word::kZ ? 3 : 0; };
  for (std::size_t i = scope.parameters.size(); i-- > 0;) {
    const int own = slot(scope.parameters[i].word);
    if (own != 0 && own == slot(word)) return scope.builder.parameter(static_cast<unsigned>(i));
  }
  return scope.builder.constant(0);
}

std::optional<Node> named(FunctionScope& scope, NameId name) {
  for (std::size_t i = scope.locals.size(); i-- > 0;) {
    if (scope.locals[i].first == name) return scope.locals[i].second;
  }
  for (std::size_t i = 0; i < scope.parameters.size(); ++i) {
    const FunctionParameter& parameter = scope.parameters[i];
    if (parameter.word == Word::kNone && parameter.name == name) return scope.builder.parameter(static_cast<unsigned>(i));
  }
  return std::nullopt;
}

[[noreturn]] void fail_name(FunctionScope& scope, const Item& item) {
  if (item.is(TokenKind::kName) && item.token.index == scope.session.being_declared) {
    scope.session.stream.take();
    scope.session.fail("Recursive function calls are not allowed!", "function-recursion");
  }
  scope.session.fail_expected("parameter identifier or floating-point constant identifier", item);
}

bool parse_word(FunctionScope& scope, Word word, Node& result) {
  TokenStream& stream = scope.session.stream;
  ExpressionBuilder& e = scope.builder;
  switch (word) {
    case Word::kPiWord: stream.take(); result = e.constant(kPi); return true;
    case Word::kClock:
      stream.take();
      result = e.constant(static_cast<double>(static_cast<float>(scope.session.options.clock)));
      return true;
    case Word::kX: case Word::kY: case Word::kZ: case Word::kU: case Word::kV:
      stream.take();
      result = slot_of(scope, word);
      return true;
    case Word::kSelect: stream.take(); result = parse_select(scope); return true;
    case Word::kSum: stream.take(); result = parse_repetition(scope, false); return true;
    case Word::kProd: stream.take(); result = parse_repetition(scope, true); return true;
    default: break;
  }
  if (const auto op = unary_function(word)) {
    stream.take();
    result = parse_built_in(scope, word, *op);
    return true;
  }
  if (const auto op = binary_function(word)) {
    stream.take();
    result = parse_built_in(scope, word, *op);
    return true;
  }
  return false;
}

bool parse_function_operand(FunctionScope& scope, NodeValue& value) {
  Session& session = scope.session;
  const Item item = session.stream.peek();
  Node& result = value.node;
  switch (item.token.kind) {
    case TokenKind::kNumber:
      session.stream.take();
      result = scope.builder.constant(item.token.number);
      return true;
    case TokenKind::kLeftParen: {
      session.stream.take();
      result = scope.builder.group(parse_expression(scope));
      session.reader.expect(TokenKind::kRightParen);
      return true;
    }
    case TokenKind::kName: {
      const std::optional<Node> node = named(scope, item.token.index);
      if (!node) fail_name(scope, item);
      session.stream.take();
      result = *node;
      return true;
    }
    case TokenKind::kIdentifier: {
      const Number* const number = item.slot->get_if<Number>();
      const FunctionPtr* const function = item.slot->get_if<FunctionPtr>();
      const std::optional<Node> node = item.subscripts == 0 ? named(scope, item.token.index) : std::nullopt;
      if (!node && function == nullptr && (number == nullptr || !number->is_float())) fail_name(scope, item);
      session.stream.take();
      if (node) {
        result = *node;
      } else {
        result = number != nullptr ? scope.builder.constant(number->c[0]) : parse_function_call(scope, FunctionPtr(*function));
      }
      return true;
    }
    case TokenKind::kWord: return parse_word(scope, item.token.word, result);
    default: return false;
  }
}

}  // namespace

Node parse_function_expression(FunctionScope& scope) { return parse_expression(scope); }

}  // namespace lute
