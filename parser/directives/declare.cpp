// #declare #local #undef, and what may stand on the right of their `=`. Source: specification chapter 10 §3.
#include <algorithm>

#include "parser/diagnostic/advice.hpp"
#include "parser/diagnostic/suggestion.hpp"
#include "parser/directives/directive.hpp"
#include "parser/expression/expression.hpp"
#include "parser/expression/nesting.hpp"
#include "parser/value/array.hpp"

namespace lute {

namespace {

[[noreturn]] void fail_unset(Session& session, const Item& item, ValueUse use) {
  if (item.slot) session.fail_at("Attempt to access uninitialized array element.", "uninitialized", item);
  if (use == ValueUse::kArgument) {
    session.fail_at("Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.", "uninitialized", item);
  }
  session.fail_at("Cannot assign uninitialized identifier.", "uninitialized", item);
}

Value numeric_value(Session& session, ValueUse use) {
  const TokenStream::AfterOperand directives(session.stream, use != ValueUse::kDeclare);
  return evaluate(session, Level::kAdditive);
}

ParsedValue new_value(Value value, bool numeric = false) {
  return {std::make_shared<Value>(std::move(value)), false, numeric};
}

// An identifier comes next: alone it stands for what it holds, else it begins an expression.
ParsedValue parse_identifier_value(Session& session, ValueUse use) {
  TokenStream& stream = session.stream;
  const Item item = stream.take();
  const Slot& slot = item.slot;
  if (slot->empty()) fail_unset(session, item, use);
  if (slot->holds<Number>()) {
    if (use == ValueUse::kArgument && stream.ends_argument()) return {slot, true, true, item.depth};
    stream.put_back(item);
    return new_value(numeric_value(session, use), true);
  }
  const bool callable = slot->holds<FunctionPtr>() || slot->holds<SplinePtr>();
  if (callable && (stream.at_written(TokenKind::kLeftParen) ||
                   (use == ValueUse::kArgument && !stream.ends_argument() && stream.peek().is(TokenKind::kLeftParen)))) {
    stream.put_back(item);
    return new_value(numeric_value(session, use), true);
  }
  if (use == ValueUse::kArgument && !slot->holds<FunctionPtr>()) return {slot, true, false, item.depth};
  session.resources.charge(size_of_copy(*slot));
  return new_value(copy(*slot));
}

}  // namespace

ParsedValue parse_value(Session& session, ValueUse use) {
  const Nesting nesting(session);
  Reader& reader = session.reader;
  const Item& next = reader.peek();
  if (next.is(TokenKind::kIdentifier) && !next.slot->holds<UserFilePtr>()) return parse_identifier_value(session, use);
  if (next.is(TokenKind::kName)) fail_unset(session, next, use);
  const Word word = next.word();
  switch (word) {
    case Word::kFunction: reader.take(); return new_value(parse_function(session, FunctionForm::kDeclared));
    case Word::kArray: reader.take(); return new_value(parse_array(session));
    case Word::kSpline: reader.take(); return new_value(parse_spline(session));
    default: break;
  }
  if (starts_string(next)) return new_value(std::make_shared<const std::u16string>(parse_string(session)));
  if (const auto found = session.declare_values.find(word); word != Word::kNone && found != session.declare_values.end()) {
    // Expressions inside a statement are parsed as everywhere else.
    const TokenStream::AfterOperand directives(session.stream, true);
    return new_value(found->second(reader));
  }
  // As in the reference, `t` can begin no value: `-t` or `(t)` can.
  if (starts_number(next) && word != Word::kT) return new_value(numeric_value(session, use), true);
  if (starts_color(next)) {
    const TokenStream::AfterOperand directives(session.stream, use != ValueUse::kDeclare);
    return new_value(Number(parse_color(session, 5).color), true);
  }
  session.fail_expected(use == ValueUse::kArgument ? "macro argument" : "RValue to declare", next);
}

namespace {

void check_element_type(Session& session, const Array& array, const Value& value) {
  const Value first = array.elements.first_value();
  if (!first.empty() && type_code(first) == type_code(value)) return;
  // An array whose elements are all undefined again still knows what they were.
  session.fail("Attempted to redefine " + std::string(first.empty() ? array.type_name : type_name(first)) + " as " +
                   std::string(type_name(value)) + ".",
               "element-type");
}

constexpr int kMostArrayNesting = 100;

// Each value is one of its own when it is assigned, so that its arrays can be counted; those around it are told. So arrays are never
// deeper than the limit, and going through them needs no other.
void check_nesting(Session& session, const Value& value, int depth) {
  if (depth + array_nesting(value) > kMostArrayNesting) session.fail("Arrays are nested too deeply.", "limit-nesting");
}

void refuse_redeclaration(Session& session) {
  session.fail("Redeclaring functions is not allowed - #undef the function first!", "function-redeclared");
}

// A variable's colour has single precision.
void round_color(Value& value) {
  if (const Number* number = value.get_if<Number>(); number != nullptr && number->count == 5) value = Number(number->color());
}

void set_element(Session& session, Array& array, std::size_t index, Value value, int depth) {
  const std::size_t type = type_code(value);
  if (array.type != type) {
    if (array.type != 0) check_element_type(session, array, value);
    array.type = type;
    array.type_name = type_name(value);
  }
  check_nesting(session, value, depth);
  const Value* const old = array.elements.find_value(index);
  if (old != nullptr && old->holds<FunctionPtr>()) refuse_redeclaration(session);
  round_color(value);
  session.resources.charge(array.elements.bytes_to_set(value));
  array.elements.set(index, std::move(value));
}

// One level of an initialiser: `{ item, item, ... }` or groups of those.
void parse_initialiser(Session& session, Array& array, std::size_t dimension, std::size_t& position) {
  Reader& reader = session.reader;
  const auto size = static_cast<std::size_t>(array.sizes[dimension]);
  reader.expect(TokenKind::kLeftBrace);
  for (std::size_t i = 0; i < size; ++i) {
    if (reader.at(TokenKind::kRightBrace)) {
      session.fail_at("Too few items in array: expected " + std::to_string(size) + " but found " + std::to_string(i) + ".",
                      "array-items", reader.peek());
    }
    if (dimension + 1 < array.sizes.size()) {
      parse_initialiser(session, array, dimension + 1, position);
    } else {
      ParsedValue value = parse_value(session, ValueUse::kElement);
      set_element(session, array, position++, std::move(*value.slot), 1);
    }
    reader.comma();
  }
  reader.close(Word::kArray);
}

}  // namespace

Value parse_array(Session& session) {
  TokenStream& stream = session.stream;
  std::vector<int> sizes;
  constexpr std::size_t kMostElements = 1u << 28;
  std::size_t count = 1;
  if (!session.reader.accept(TokenKind::kLeftSquare)) {
    session.fail_at("An array declaration must have at least one dimension", "array-dimensions", session.reader.peek());
  }
  do {
    if (sizes.size() == 5) session.fail("Too many array dimensions", "array-dimensions");
    const double size = session.reader.number() + kEpsilon;
    if (!(size >= 1) || size > static_cast<double>(kMostElements)) {
      session.fail("Invalid dimension size for an array", "array-dimensions");
    }
    sizes.push_back(static_cast<int>(size));
    count *= static_cast<std::size_t>(size);
    if (count > kMostElements) session.fail("This array would need more memory than is allowed.", "limit-memory");
    session.reader.expect(TokenKind::kRightSquare);
  } while (stream.at_written(TokenKind::kLeftSquare) && session.reader.accept(TokenKind::kLeftSquare));
  session.resources.require(static_cast<double>(count * sizeof(double)));
  auto array = std::make_shared<Array>(std::move(sizes));
  std::size_t position = 0;
  if (stream.at_written(TokenKind::kLeftBrace)) parse_initialiser(session, *array, 0, position);
  return array;
}

std::size_t select_element(Session& session, const Array& array, std::uint16_t& subscripts) {
  TokenStream& stream = session.stream;
  const TokenStream::Aside aside(stream, true);
  std::size_t index = 0;
  for (const int size : array.sizes) {
    const Item open = stream.take_raw();
    if (!open.is(TokenKind::kLeftSquare)) session.fail_expected("[", open);
    const double subscript = session.reader.number() + kEpsilon;
    session.reader.expect(TokenKind::kRightSquare);
    if (subscript < 0) session.fail("Negative subscript", "subscript");
    if (!(subscript < size)) {
      session.fail("Array subscript out of range", "subscript", index_advice("the elements", static_cast<std::size_t>(size), subscript));
    }
    index = index * static_cast<std::size_t>(size) + static_cast<std::size_t>(subscript);
    ++subscripts;
  }
  return index;
}

WrittenElement written_element(Session& session, const Item& name) {
  WrittenElement element;
  element.depth = name.depth;
  const Value* next = name.slot.get();
  std::uint16_t subscripts = 0;
  while (next != nullptr && next->holds<ArrayPtr>() && session.stream.at_written(TokenKind::kLeftSquare)) {
    element.array = *next->get_if<ArrayPtr>();
    element.index = select_element(session, *element.array, subscripts);
    ++element.depth;
    next = element.array->elements.find_value(element.index);
  }
  return element;
}

void assign(Session& session, Value& target, Value value, int depth) {
  check_nesting(session, value, depth);
  if (target.holds<FunctionPtr>()) refuse_redeclaration(session);
  round_color(value);
  target = std::move(value);
}

namespace {

std::shared_ptr<Deprecation> parse_deprecation(Session& session) {
  TokenStream& stream = session.stream;
  if (!stream.at_written(Word::kDeprecated)) return nullptr;
  stream.take_raw();
  auto deprecation = std::make_shared<Deprecation>();
  if (stream.at_written(Word::kOnce)) {
    stream.take_raw();
    deprecation->once = true;
  }
  if (starts_string(stream.peek_raw())) deprecation->message = to_bytes(session, parse_string(session));
  return deprecation;
}

bool is_comparison(TokenKind kind) {
  switch (kind) {
    case TokenKind::kLess: case TokenKind::kLessEqual: case TokenKind::kEqual: case TokenKind::kNotEqual:
    case TokenKind::kGreaterEqual: case TokenKind::kGreater: case TokenKind::kAnd: case TokenKind::kOr:
    case TokenKind::kQuestion: return true;
    default: return false;
  }
}

// The `;` behind a value. Numbers must have it; behind anything else one is swallowed.
void end_declaration(Session& session, bool numeric) {
  TokenStream& stream = session.stream;
  if (!numeric) {
    if (stream.at_written(TokenKind::kSemicolon)) stream.take();
    return;
  }
  const TokenStream::AfterOperand no_directives(stream, false);
  stream.fetch_after_operand();
  if (stream.peek().is(TokenKind::kSemicolon)) {
    stream.take();
    return;
  }
  const char* const message =
      "All #declares of float, vector, and color require semi-colon ';' at end if the language version is set to 3.5 or higher. "
      "Either add the semi-colon or set the language version to 3.1 or lower.";
  if (session.language.version >= 350) {
    const bool compares = is_comparison(stream.peek().token.kind);
    const bool lacks_color = stream.last_token != nullptr && stream.last_token->kind == TokenKind::kWord &&
                             stream.last_token->word == Word::kColor;
    session.fail_after(message, "missing-semicolon",
                       compares      ? "comparisons and & | ? need parentheses around the whole expression here"
                       : lacks_color ? suggestion(session, stream.peek())
                                     : "");
  }
  if (session.language.version >= 310) session.possible_error(message, "missing-semicolon");
}

// What a #declare gives a value to: an identifier, or an element of the array that it is.
struct DeclareTarget {
  NameId id = 0;
  std::uint32_t table = 0;  // the scope of the identifier
  WrittenElement element;   // no array: the identifier itself
};

// Marks the name whose value is being read, also when reading it throws.
class BeingDeclared {
 public:
  BeingDeclared(Session& session, NameId name) : session_(session), outer_(std::exchange(session.being_declared, name)) {}
  ~BeingDeclared() { session_.being_declared = outer_; }
  BeingDeclared(const BeingDeclared&) = delete;
  BeingDeclared& operator=(const BeingDeclared&) = delete;

 private:
  Session& session_;
  std::optional<NameId> outer_;
};

DeclareTarget read_target(Session& session, const Item& name, bool local) {
  const bool undeclared = name.is(TokenKind::kName);
  const auto keeps_its_type = [](const Value& value) { return value.holds<MacroPtr>() || value.holds<UserFilePtr>(); };
  if (!undeclared && (!name.is(TokenKind::kIdentifier) || keeps_its_type(*name.slot))) {
    session.fail_expected("undeclared identifier", name);
  }
  DeclareTarget target;
  target.id = name.token.index;
  // The scope is that of the directive, not that of a macro whose call is the value and which has not ended yet.
  target.table = session.symbols.newest();
  if (!local) {
    const SymbolTable::Entry* known = session.symbols.find(target.id);
    target.table = known != nullptr ? known->table : 0;
  }
  if (undeclared) return target;
  target.element = written_element(session, name);
  return target;
}

void store(Session& session, const DeclareTarget& target, Slot value, std::shared_ptr<Deprecation> deprecation) {
  if (target.element.array) {
    set_element(session, *target.element.array, target.element.index, std::move(*value), target.element.depth);
    return;
  }
  const std::uint32_t table = std::min(target.table, session.symbols.newest());  // the value may have ended the scope
  SymbolTable::Entry* entry = session.symbols.find_in(target.id, table);
  if (entry != nullptr) {
    assign(session, *entry->slot, std::move(*value), entry->depth);
  } else {
    Value fresh;
    assign(session, fresh, std::move(*value));
    *value = std::move(fresh);
    entry = &session.symbols.add(target.id, table, std::move(value));
  }
  if (deprecation) entry->deprecation = std::move(deprecation);
}

}  // namespace

void run_declare(Session& session, bool local) {
  TokenStream& stream = session.stream;
  const Token* const keyword = stream.last_token;
  std::shared_ptr<Deprecation> deprecation = parse_deprecation(session);
  const Item name = stream.take_raw();
  const DeclareTarget target = read_target(session, name, local);
  if (deprecation && deprecation->message.empty()) {
    deprecation->message = "Identifier '" + std::string(session.names.text(target.id)) + "' was declared deprecated.";
  }
  const Item equals = stream.take_raw();
  if (!equals.is(TokenKind::kEqual)) session.fail_expected("=", equals);
  ParsedValue value;
  {
    const BeingDeclared mark(session, target.id);
    value = parse_value(session, ValueUse::kDeclare);
  }
  end_declaration(session, value.numeric);
  if (value.numeric && !target.element.array && keyword + 1 == name.source && name.source + 1 == equals.source) {
    KnownDirective known;
    known.word = local ? Word::kLocal : Word::kDeclare;
    known.name = target.id;
    remember_directive(session, keyword - 1, known, equals.source + 1, TokenKind::kSemicolon);
  }
  store(session, target, std::move(value.slot), std::move(deprecation));
  if (value.numeric) stream.pass_second_semicolon();
}

void run_undef(Session& session) {
  TokenStream& stream = session.stream;
  const Item name = stream.take_raw();
  if (name.is(TokenKind::kName)) {
    session.warn("Attempt to undef unknown identifier", "undef-unknown");
    return;
  }
  if (!name.is(TokenKind::kIdentifier)) session.fail_expected("undeclared identifier", name);
  if (const WrittenElement element = written_element(session, name); element.array) {
    if (!element.array->elements.has_value(element.index)) {
      session.fail_at("Attempt to access uninitialized array element.", "uninitialized", name);
    }
    element.array->elements.set(element.index, Value());
  } else {
    session.symbols.remove(name.token.index);
  }
}

}  // namespace lute
