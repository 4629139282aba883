// The one interface that statement parsers read a scene through: tokens with all directives and macro calls already executed,
// and the expressions of the language. Every method that meets something it does not expect throws a SceneError with the
// reference's message. Source: specification chapters 10 and 11 §1.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/scene/geometry_query.hpp"
#include "parser/diagnostic/diagnostic.hpp"
#include "parser/lexer/token.hpp"
#include "parser/value/value.hpp"

namespace lute {

struct Session;  // parser/session.hpp: everything a parse keeps
class StatementState;  // parser/statement/statement.hpp

// A token as the statements see it.
struct Item {
  Token token;
  std::uint32_t file = 0;  // where token.offset counts
  Slot slot;               // kIdentifier: the value it names (never empty for a declared name)
  const Token* source = nullptr;  // the token in its file; of an array element the array's name
  std::uint16_t subscripts = 0;   // of an array element: how many were read
  std::uint8_t depth = 0;         // arrays in each other that its value lies in: 1 for an element of a variable

  bool is(TokenKind kind) const { return token.kind == kind; }
  bool is(Word word) const { return token.kind == TokenKind::kWord && token.word == word; }
  Word word() const { return token.kind == TokenKind::kWord ? token.word : Word::kNone; }  // for switch statements
};

class Reader {
 public:
  explicit Reader(Session& session) : session_(session) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  // Tokens. Peeking executes the directives and macro calls in front of the token.
  const Item& peek();
  Item take();
  bool at(TokenKind kind) { return peek().is(kind); }
  bool at(Word word) { return peek().is(word); }
  Word word() { return peek().word(); }  // Word::kNone unless a reserved word comes next
  bool accept(TokenKind kind);           // takes it if it is next
  bool accept(Word word);
  // The same, but a directive or a macro call that stands in front of the word is neither executed nor skipped: it ends what was read.
  bool accept_written(Word word);
  void expect(TokenKind kind);           // Expected '...', ... found instead
  void expect(Word word);
  // The next token as it is written, without executing what stands in front of it: for deciding whether a #declare's value goes
  // on (layered textures), where the reference runs no directives either.
  bool at_written(Word word);
  void comma() { accept(TokenKind::kComma); }  // commas are optional everywhere

  // Blocks: `open` after the keyword was taken. "Missing { after 'sphere', ..." and "No matching } in 'sphere', ...".
  void open(Word keyword);
  void close(Word keyword);

  // Expressions. number() to vector4() read one additive expression with the promotions of chapter 10 §7.2.
  double number();
  int integer();  // a number truncated toward zero, saturating
  dvec2 vector2();
  dvec3 vector();
  dvec4 vector4();
  Number full_expression(int minimum_count);      // comparisons, & | and ?: allowed
  Number additive_expression(int minimum_count);
  double condition_number();                      // a full expression that must be a float
  bool at_number();  // the next token can start a numeric expression
  std::optional<double> optional_number();        // a number if one can start here
  bool optional_flag() { return optional_number().value_or(1.0) > 0; }  // BOOL? of chapter 11

  // Colours (chapter 11 §1.1). color() has filter and transmit; rgb() warns if they are not zero and drops them.
  Color color();
  Rgb rgb();
  bool at_color();  // the next token can start a colour

  // Strings. text() is string() as UTF-8; file_name() takes backslashes literally (chapter 10 §1.3).
  std::u16string string();
  std::string text();
  std::string file_name();
  bool at_string();

  // Takes the next token if it is an identifier that holds a T, for example ObjectPtr or TexturePtr.
  template <class T>
  std::optional<T> accept_identifier() {
    const Item& next = peek();
    if (next.token.kind != TokenKind::kIdentifier || !next.slot->holds<T>()) return std::nullopt;
    std::optional<T> value = *next.slot->get_if<T>();
    take();
    return value;
  }
  template <class T>
  bool at_identifier() {
    const Item& next = peek();
    return next.token.kind == TokenKind::kIdentifier && next.slot->holds<T>();
  }

  // A user function as statements use it, the keyword `function` was taken: `{ expression }` of x, y and z, with a number for a value.
  FunctionPtr float_function();
  // The same with any other body, a pigment for instance, or an identifier that holds a function.
  FunctionPtr any_function();

  // A file found by the search rules of chapter 10 §6.1; nothing if there is none. `extensions` are tried in order.
  std::optional<std::string> find_file(const std::string& name, std::initializer_list<std::string_view> extensions = {});

  // Places and messages.
  SourceLocation location() const;         // of the token taken last
  SourceLocation next_location();          // of the token that comes next
  [[noreturn]] void error(std::string message, std::string code = "scene-error", std::string hint = "");  // at the token taken last
  [[noreturn]] void error_expected(std::string_view what);  // Expected 'what', <next token> found instead
  // A warning whose level is at or above the language version is silent (chapter 11 §1.7).
  void warning(std::string message, int level = 0);
  void possible_error(std::string message);

  // The language: version times 100 (370), and 362 in place of it when no #version was given.
  int version() const;
  int effective_version() const;

  // `assumed_gamma` was given: needed before `srgb` colours. Set by the global_settings statement, which also sets scene().settings.
  bool assumed_gamma_given() const;
  void set_assumed_gamma_given();
  void set_noise_generator_given();  // #version no longer sets scene().settings.noise_generator
  enum class Charset : std::uint8_t { kAscii, kUtf8, kSystem };
  void set_charset(Charset charset);

  Scene& scene();
  StatementState& statements();
  GeometryQuery* geometry();  // may be null: then trace and its kin are errors
  TextureFunctions* texture_functions();
  Session& session() { return session_; }

 private:
  Session& session_;
};

}  // namespace lute
