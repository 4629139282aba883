// The lexer: Boost.Spirit X3, dispatching on the first byte; blanks and comments are tokens that leave nothing behind. No
// skipper, no synthesised attributes, plain pointers: measured 1.3 to 1.5 times the time of a hand-written scanner.
// Source: specification chapter 10 §1.1-1.3.
#include <algorithm>
#include <array>
#include <boost/spirit/home/x3.hpp>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <tuple>

#include "parser/lexer/source_file.hpp"

namespace lute {

namespace {

namespace x3 = boost::spirit::x3;

constexpr std::size_t kMaximumLength = 255;  // of names and string literals

struct LexFailure {
  const char* where;
  std::string message;
  const char* resume;  // where text that can be read begins again
};

struct LexState {
  SourceFile& file;
  Names& names;
  Tokens& tokens;
  const char* begin;
  const char* piece_end;              // behind this no more tokens are made, unless the last one is a `#`
  const char* next_run = nullptr;     // where it is worth looking for a run of literals again; null: never
  const char* token_begin = nullptr;  // set by Dispatch: an action cannot know where its match started

  bool piece_ends_at(const char* p) const { return p >= piece_end && !behind_hash(); }
  // A directive's `#` is followed by its word; of nothing but many of them the file is no scene.
  bool behind_hash() const {
    constexpr std::size_t kMany = 64;
    const auto is_hash = [](const Token& token) { return token.kind == TokenKind::kHash; };
    if (tokens.empty() || !is_hash(tokens.back())) return false;
    return tokens.size() < kMany || !std::all_of(tokens.end() - kMany, tokens.end(), is_hash);
  }

  Token& push(TokenKind kind) {
    Token token;
    token.kind = kind;
    token.offset = static_cast<std::uint32_t>(token_begin - begin);
    tokens.push_back(token);
    return tokens.back();
  }
};
struct LexTag;

enum ByteClass : std::uint8_t { kBlank, kLetter, kDigit, kDot, kQuote, kSlashByte, kCompare, kSingle, kIllegal };

constexpr std::array<std::uint8_t, 256> make_byte_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (auto& c : classes) c = kIllegal;
  for (const char c : {'\0', '\t', '\n', '\v', '\f', '\r', ' ', '\x1A'}) classes[static_cast<unsigned char>(c)] = kBlank;
  for (unsigned c = 'a'; c <= 'z'; ++c) classes[c] = kLetter;
  for (unsigned c = 'A'; c <= 'Z'; ++c) classes[c] = kLetter;
  classes['_'] = kLetter;
  for (unsigned c = '0'; c <= '9'; ++c) classes[c] = kDigit;
  for (const char c : {'{', '}', '(', ')', '[', ']', ',', ';', ':', '+', '-', '*', '&', '|', '=', '?', '#', '@', '$', '%', '^',
                       '~', '\'', '\\', '`'}) {
    classes[static_cast<unsigned char>(c)] = kSingle;
  }
  classes['.'] = kDot;
  classes['"'] = kQuote;
  classes['/'] = kSlashByte;
  classes['<'] = classes['>'] = classes['!'] = kCompare;
  return classes;
}
constexpr std::array<std::uint8_t, 256> kByteClasses = make_byte_classes();

constexpr std::uint8_t class_of(char c) { return kByteClasses[static_cast<unsigned char>(c)]; }

constexpr TokenKind single_kind(char c) {
  switch (c) {
    case '{': return TokenKind::kLeftBrace;
    case '}': return TokenKind::kRightBrace;
    case '(': return TokenKind::kLeftParen;
    case ')': return TokenKind::kRightParen;
    case '[': return TokenKind::kLeftSquare;
    case ']': return TokenKind::kRightSquare;
    case ',': return TokenKind::kComma;
    case ';': return TokenKind::kSemicolon;
    case ':': return TokenKind::kColon;
    case '?': return TokenKind::kQuestion;
    case '.': return TokenKind::kPeriod;
    case '+': return TokenKind::kPlus;
    case '-': return TokenKind::kMinus;
    case '*': return TokenKind::kStar;
    case '/': return TokenKind::kSlash;
    case '&': return TokenKind::kAnd;
    case '|': return TokenKind::kOr;
    case '=': return TokenKind::kEqual;
    case '#': return TokenKind::kHash;
    case '<': return TokenKind::kLess;
    case '>': return TokenKind::kGreater;
    case '!': return TokenKind::kExclamation;
    default: return TokenKind::kOther;
  }
}

// Parsers without attribute: what they find goes to the LexState.
struct NoAttribute {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
};

// A run of bytes of the classes from `First` to `Last`.
template <std::uint8_t First, std::uint8_t Last>
struct Run : x3::parser<Run<First, Last>>, NoAttribute {
  using attribute_type = NoAttribute::attribute_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const&, R&, A&) const {
    It p = first;
    while (p != last && class_of(*p) >= First && class_of(*p) <= Last) ++p;
    if (p == first) return false;
    first = p;
    return true;
  }
};

// An unsigned number, rounded correctly; no nan, no inf, no hexadecimals. "1e" and "1e+" are 1. (x3::real_parser rounds
// wrongly in a third of all 17-digit numbers.)
struct Real : x3::parser<Real> {
  using attribute_type = double;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const&, R&, A& attribute) const {
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    if (first == last || !(digit(*first) || (*first == '.' && last - first > 1 && digit(first[1])))) return false;
    double value = 0;
    auto [p, error] = std::from_chars(first, last, value);
    // from_chars leaves the value alone when it is out of range.
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(first, p).c_str(), nullptr);
    if (p != last && (*p == 'e' || *p == 'E')) {
      ++p;
      if (p != last && (*p == '+' || *p == '-')) ++p;
    }
    if (p != last && *p == '.') {
      const char* const where = p;
      while (p != last && (*p == '.' || digit(*p))) ++p;
      throw LexFailure{where, "Unexpected additional '.' in floating-point number", p};
    }
    first = p;
    x3::traits::move_to(value, attribute);
    return true;
  }
};

// A comment between /* and */; they nest, and depth costs no stack.
struct BlockComment : x3::parser<BlockComment> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const&, R&, A&) const {
    if (last - first < 2 || first[0] != '/' || first[1] != '*') return false;
    It p = first + 2;
    for (std::size_t depth = 1; depth > 0;) {
      if (last - p < 2) throw LexFailure{first, "No */ closing comment found.", last};
      if (p[0] == '*' && p[1] == '/') {
        --depth;
        p += 2;
      } else if (p[0] == '/' && p[1] == '*') {
        ++depth;
        p += 2;
      } else {
        ++p;
      }
    }
    first = p;
    return true;
  }
};

constexpr std::size_t kLargeFile = 1u << 20;  // from this size on runs are looked for
constexpr std::ptrdiff_t kSmallestRun = 4096;

constexpr bool in_run(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '-' || c == '+' || c == '<' || c == '>' || c == 'e' || c == 'E' ||
         class_of(c) == kBlank;
}

// The last place in (first, last) at which no token is cut: behind a `,` or a `>` that is not `>=`. `first` if there is none.
const char* last_border(const char* first, const char* last, const char* end) {
  for (const char* p = last; p != first; --p) {
    if (p[-1] == ',' || (p[-1] == '>' && !(p != end && *p == '='))) return p;
  }
  return first;
}

// A long run of literals in a large file: one token, which is read when it is needed.
struct Literals : x3::parser<Literals> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R&, A&) const {
    LexState& state = x3::get<LexTag>(context).get();
    if (state.next_run == nullptr || first < state.next_run) return false;
    It p = first;
    while (p != last && in_run(*p)) ++p;
    const It border = last_border(first, p, last);
    if (border - first < kSmallestRun) {
      state.next_run = p;
      return false;
    }
    state.push(TokenKind::kRun).index = static_cast<std::uint32_t>(state.file.runs.size());
    state.file.runs.push_back({static_cast<std::uint32_t>(first - state.begin), static_cast<std::uint32_t>(border - state.begin)});
    state.file.storage.release(static_cast<std::size_t>(first - state.begin), static_cast<std::size_t>(border - state.begin));
    first = border;
    return true;
  }
};

// First byte -> class -> parser.
template <class... P>
struct Dispatch : x3::parser<Dispatch<P...>> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  std::tuple<P...> parsers;
  constexpr explicit Dispatch(P const&... p) : parsers(p...) {}

  template <std::size_t N, class It, class C, class R>
  bool pick(unsigned k, It& first, It const& last, C const& context, R& rcontext) const {
    if constexpr (N == sizeof...(P)) {
      return false;
    } else {
      return k == N ? std::get<N>(parsers).parse(first, last, context, rcontext, x3::unused)
                    : pick<N + 1>(k, first, last, context, rcontext);
    }
  }
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const& context, R& rcontext, A&) const {
    if (first == last) return false;
    LexState& state = x3::get<LexTag>(context).get();
    if (state.piece_ends_at(first)) return false;
    state.token_begin = first;
    return pick<0>(class_of(*first), first, last, context, rcontext);
  }
};
template <class... P>
constexpr Dispatch<typename x3::extension::as_parser<P>::value_type...> dispatch(P const&... p) {
  return Dispatch<typename x3::extension::as_parser<P>::value_type...>{x3::as_parser(p)...};
}

template <class Context>
LexState& state_of(Context const& context) { return x3::get<LexTag>(context).get(); }

void push_name(LexState& state, const char* end) {
  const auto length = static_cast<std::size_t>(end - state.token_begin);
  if (length > kMaximumLength) throw LexFailure{state.token_begin, "String too long.", end};
  const NameId id = state.names.intern({state.token_begin, length});
  if (Names::is_word(id)) {
    state.push(TokenKind::kWord).word = canonical(static_cast<Word>(id));
  } else {
    state.push(TokenKind::kName).index = id;
  }
}

void push_string(LexState& state, const char* first, const char* last) {
  if (last - first > static_cast<std::ptrdiff_t>(kMaximumLength)) {
    const bool closed = last != state.begin + state.file.text.size();
    throw LexFailure{state.token_begin, "String too long.", closed ? last + 1 : last};
  }
  std::string text;
  for (const char* p = first; p != last; ++p) {
    if (*p == '\\' && p[1] == '"') ++p;  // the only escape that is resolved here
    text += *p;
    // Of a doubled backslash the second one escapes nothing.
    if (*p == '\\' && p + 1 != last && p[1] == '\\') text += *++p;
  }
  state.push(TokenKind::kString).index = static_cast<std::uint32_t>(state.file.strings.size());
  state.file.strings.push_back(std::move(text));
}

[[noreturn]] void fail_illegal(const char* where, const char* end) {
  char text[64];
  std::snprintf(text, sizeof text, "Illegal character in input file, value is %02x.", static_cast<unsigned char>(*where));
  const char* resume = where;
  while (resume != end && class_of(*resume) == kIllegal) ++resume;  // the bytes of one letter are one error
  throw LexFailure{where, text, resume};
}

struct Illegal : x3::parser<Illegal> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;
  template <class It, class C, class R, class A>
  bool parse(It& first, It const& last, C const&, R&, A&) const {
    fail_illegal(first, last);
  }
};

auto make_tokens() {
  const auto name_action = [](auto& context) { push_name(state_of(context), x3::_attr(context).end()); };
  const auto number_action = [](auto& context) { state_of(context).push(TokenKind::kNumber).number = x3::_attr(context); };
  const auto string_action = [](auto& context) {
    push_string(state_of(context), x3::_attr(context).begin(), x3::_attr(context).end());
  };
  const auto single_action = [](auto& context) {
    LexState& state = state_of(context);
    const char c = *state.token_begin;
    Token& token = state.push(single_kind(c));
    if (token.kind == TokenKind::kOther) token.index = static_cast<unsigned char>(c);
  };
  const auto kind_action = [](TokenKind kind) { return [kind](auto& context) { state_of(context).push(kind); }; };
  const auto unclosed = [](auto& context) {
    const LexState& state = state_of(context);
    throw LexFailure{state.token_begin, "No end quote for string.", state.begin + state.file.text.size()};
  };
  const auto broken = [](auto& context) {
    throw LexFailure{state_of(context).token_begin, "Unterminated string literal.", &*x3::_where(context).begin()};
  };

  const auto blanks = x3::omit[Run<kBlank, kBlank>{}];
  const auto name = x3::raw[Run<kLetter, kDigit>{}][name_action];
  const auto literal = Real{}[number_action];
  const auto number = Literals{} | literal;
  const auto dot = literal | x3::omit[x3::lit('.')][single_action];
  const auto body = *(+~x3::char_("\"\\") | (x3::lit('\\') >> (x3::omit[x3::char_("\r\n")][broken] | x3::omit[~x3::char_("\r\n")])));
  const auto string = x3::lit('"') >> x3::raw[body][string_action] >> (x3::lit('"') | x3::omit[x3::eps][unclosed]);
  const auto line_comment = x3::lit("//") >> x3::omit[*~x3::char_("\r\n")];
  const auto slash = line_comment | BlockComment{} | x3::omit[x3::lit('/')][single_action];
  const auto compare = Literals{} | x3::omit[x3::lit("<=")][kind_action(TokenKind::kLessEqual)] |
                       x3::omit[x3::lit(">=")][kind_action(TokenKind::kGreaterEqual)] |
                       x3::omit[x3::lit("!=")][kind_action(TokenKind::kNotEqual)] |
                       x3::omit[x3::char_("<>!")][single_action];
  const auto single = x3::omit[x3::char_][single_action];
  return *dispatch(blanks, name, number, dot, string, slash, compare, single, Illegal{});
}

}  // namespace

namespace {

// From p to the end of the piece or the text, past what cannot be read; kEnd or kMore follows. Returns where it ended.
const char* lex_text(LexState& state, const char* p, const char* end) {
  static const auto tokens = make_tokens();
  const auto grammar = x3::with<LexTag>(std::ref(state))[tokens];
  while (p != end && !state.piece_ends_at(p)) {
    try {
      x3::parse(p, end, grammar);
      if (p != end && !state.piece_ends_at(p)) fail_illegal(p, end);
    } catch (const LexFailure& failure) {
      state.token_begin = failure.where;
      state.push(TokenKind::kError).index = static_cast<std::uint32_t>(state.file.errors.size());
      state.file.errors.push_back(failure.message);
      constexpr std::size_t kMostErrors = 1000;  // behind so many the file is no scene
      p = state.file.errors.size() < kMostErrors ? std::max(failure.resume, p) : end;
    }
  }
  state.token_begin = p;
  state.push(p == end ? TokenKind::kEnd : TokenKind::kMore);
  return p;
}

constexpr std::size_t kPiece = 1u << 18;  // bytes

void lex_piece(SourceFile& file, Names& names, std::size_t size, bool runs) {
  const char* const begin = file.text.data();
  const char* const end = begin + file.text.size();
  const char* const from = begin + file.lexed;
  const char* const to = static_cast<std::size_t>(end - from) > size ? from + size : end;
  if (!file.tokens.empty()) file.tokens.pop_back();
  LexState state{file, names, file.tokens, begin, to, runs ? std::max(from, begin + file.next_run) : nullptr};
  const std::uint32_t before = file.lexed;
  file.lexed = static_cast<std::uint32_t>(lex_text(state, from, end) - begin);
  if (runs) file.next_run = static_cast<std::uint32_t>(state.next_run - begin);
  // The piece before this one was read; of this one, lines are still counted.
  file.storage.release(before > kPiece ? before - kPiece : 0, before);
}

void prepare(SourceFile& file, bool main_file) {
  std::uint32_t& mark = file.lexed;
  while (main_file && mark < file.text.size() && static_cast<unsigned char>(file.text[mark]) > 127) ++mark;
  file.byte_order_mark = mark != 0;
  file.tokens.reserve(file.text.size() + 2);  // a token takes at least a byte
}

}  // namespace

void lex(SourceFile& file, Names& names, bool main_file) {
  prepare(file, main_file);
  lex_piece(file, names, file.text.size(), false);
}

void begin_lexing(SourceFile& file, Names& names, bool main_file) {
  prepare(file, main_file);
  lex_more(file, names);
}

void lex_more(SourceFile& file, Names& names) { lex_piece(file, names, kPiece, file.text.size() >= kLargeFile); }

void lex_run(SourceFile& file, Names& names, const LiteralRun& run, std::uint32_t& position, Tokens& tokens) {
  constexpr std::uint32_t kChunk = 1u << 15;  // bytes
  const char* const begin = file.text.data();
  const char* const from = begin + position;
  const char* const run_end = begin + run.end;
  const char* to = run_end;
  if (run.end - position > kChunk) to = last_border(from, from + kChunk, run_end);
  if (to == from) to = run_end;
  tokens.clear();
  LexState state{file, names, tokens, begin, to, nullptr};
  lex_text(state, from, to);
  // The memory of what was read a while ago.
  constexpr std::uint32_t kReleased = 1u << 22;
  const auto end_position = static_cast<std::uint32_t>(to - begin);
  if (position / kReleased != end_position / kReleased) {
    file.storage.release(position > 2 * kReleased ? position - 2 * kReleased : 0, position);
  }
  position = end_position;
}

std::string_view name_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEnd:
    case TokenKind::kMore: return "End of File";
    case TokenKind::kError: return "unreadable text";
    case TokenKind::kNumber: return "float constant";
    case TokenKind::kString: return "string literal";
    case TokenKind::kName: return "undeclared identifier";
    case TokenKind::kRun: return "float constant";
    case TokenKind::kWord: return "reserved word";
    case TokenKind::kIdentifier: return "identifier";
    case TokenKind::kLeftBrace: return "{";
    case TokenKind::kRightBrace: return "}";
    case TokenKind::kLeftParen: return "(";
    case TokenKind::kRightParen: return ")";
    case TokenKind::kLeftSquare: return "[";
    case TokenKind::kRightSquare: return "]";
    case TokenKind::kLess: return "<";
    case TokenKind::kGreater: return ">";
    case TokenKind::kLessEqual: return "<=";
    case TokenKind::kGreaterEqual: return ">=";
    case TokenKind::kNotEqual: return "!=";
    case TokenKind::kEqual: return "=";
    case TokenKind::kComma: return ", ";
    case TokenKind::kSemicolon: return ";";
    case TokenKind::kColon: return ":";
    case TokenKind::kQuestion: return "?";
    case TokenKind::kPeriod: return ". (period)";
    case TokenKind::kPlus: return "+";
    case TokenKind::kMinus: return "-";
    case TokenKind::kStar: return "*";
    case TokenKind::kSlash: return "/";
    case TokenKind::kAnd: return "&";
    case TokenKind::kOr: return "|";
    case TokenKind::kExclamation: return "!";
    case TokenKind::kHash: return "#";
    case TokenKind::kOther: return "stray character";
  }
  return "";
}

}  // namespace lute
