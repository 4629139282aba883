// Parts of the two X3 grammars over tokens (scene expressions, function bodies): the cursor and the parser of all binary levels.
// Included by those two sources only: X3 is expensive to compile.
#pragma once

#include <boost/spirit/home/x3.hpp>
#include <iterator>

#include "parser/expression/nesting.hpp"

namespace lute {

inline Session& session_of(Session& session) { return session; }

// The next token of the stream. The grammars decide on one token, so a cursor never has to go back: copies are the same cursor.
template <class State>
class TokenCursor {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = Item;
  using difference_type = std::ptrdiff_t;
  using pointer = const Item*;
  using reference = const Item&;

  TokenCursor() = default;
  explicit TokenCursor(State& state) : state_(&state) {}
  const Item& operator*() const { return session_of(*state_).stream.peek(); }
  const Item* operator->() const { return &session_of(*state_).stream.peek(); }
  TokenCursor& operator++() {
    session_of(*state_).stream.take();
    return *this;
  }
  TokenCursor operator++(int) { return ++*this; }
  // The end of the text is a token: no cursor is ever at the end of the range.
  friend bool operator==(const TokenCursor& a, const TokenCursor& b) { return a.state_ == b.state_; }
  friend bool operator!=(const TokenCursor& a, const TokenCursor& b) { return a.state_ != b.state_; }
  State& state() const { return *state_; }

 private:
  State* state_ = nullptr;
};

// Operands joined by binary, left-associative operators of level kMinimum and above (precedence climbing). `Operators` has
// Value, kOperand (a name for messages), level(kind) with 0 for no operator, and combine(state, kind, left, right).
template <int kMinimum, class Operators, class P>
struct Climb : boost::spirit::x3::unary_parser<P, Climb<kMinimum, Operators, P>> {
  using base_type = boost::spirit::x3::unary_parser<P, Climb<kMinimum, Operators, P>>;
  using Value = typename Operators::Value;
  using attribute_type = Value;
  static bool const has_attribute = true;
  constexpr explicit Climb(P const& p) : base_type(p) {}

  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A& attribute) const {
    return this->subject.parse(first, last, context, rcontext, attribute) &&
           fold(kMinimum, first, last, context, rcontext, attribute);
  }

  template <class It, class C, class R>
  bool fold(int minimum, It& first, It const& last, C const& context, R& rcontext, Value& left) const {
    for (;;) {
      const TokenKind op = first->token.kind;
      const int level = Operators::level(op);
      if (level == 0 || level < minimum) return true;
      ++first;
      Value right{};
      if (!this->subject.parse(first, last, context, rcontext, right)) {
        session_of(first.state()).fail_expected(Operators::kOperand, *first);
      }
      while (Operators::level(first->token.kind) > level) fold(level + 1, first, last, context, rcontext, right);
      left = Operators::combine(first.state(), op, left, right);
    }
  }
};
template <int kMinimum, class Operators, class P>
constexpr auto climb(P const& p) {
  namespace x3 = boost::spirit::x3;
  return Climb<kMinimum, Operators, typename x3::extension::as_parser<P>::value_type>(x3::as_parser(p));
}

}  // namespace lute
