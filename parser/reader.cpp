#include "parser/reader.hpp"

#include "parser/diagnostic/suggestion.hpp"
#include "parser/expression/expression.hpp"
#include "parser/session.hpp"

namespace lute {

const Item& Reader::peek() { return session_.stream.peek(); }
Item Reader::take() { return session_.stream.take(); }

bool Reader::accept(TokenKind kind) {
  if (!peek().is(kind)) return false;
  take();
  return true;
}

bool Reader::accept(Word wanted) {
  if (!peek().is(wanted)) return false;
  take();
  return true;
}

bool Reader::accept_written(Word wanted) {
  if (!session_.stream.window_empty()) return accept(wanted);
  const Item next = session_.stream.peek_raw();
  return next.is(wanted) && accept(wanted);
}

void Reader::expect(TokenKind kind) {
  if (!accept(kind)) error_expected(name_of(kind));
}

void Reader::expect(Word wanted) {
  if (!accept(wanted)) error_expected(spelling(wanted));
}

bool Reader::at_written(Word wanted) { return session_.stream.at_written(wanted); }

void Reader::open(Word keyword) {
  const OpenBlock block{session_.stream.last_file, session_.stream.last_token};
  const Item& next = peek();
  if (!next.is(TokenKind::kLeftBrace)) {
    session_.fail_at("Missing { after '" + std::string(spelling(keyword)) + "', " + printed_name(session_, next) + " found instead",
                     "missing-brace", next);
  }
  take();
  session_.open_blocks.push_back(block);
  if (session_.open_blocks.size() > session_.options.limits.blocks) {
    session_.fail("Braces are nested too deeply: the limit is " + std::to_string(session_.options.limits.blocks) + ".", "limit-blocks");
  }
}

void Reader::close(Word keyword) {
  const Item& next = peek();
  if (!next.is(TokenKind::kRightBrace)) {
    Diagnostic diagnostic = session_.diagnose(
        Severity::kError, "missing-brace",
        "No matching } in '" + std::string(spelling(keyword)) + "', " + printed_name(session_, next) + " found instead", next.file,
        next.source);
    diagnostic.hint = suggestion(session_, next, "", spelling(keyword));
    if (!session_.open_blocks.empty()) {
      const OpenBlock& block = session_.open_blocks.back();
      const SourceLocation where = session_.locate(block.file, block.keyword);
      if (where.line != diagnostic.where.line || where.file != diagnostic.where.file) {
        diagnostic.chain.insert(diagnostic.chain.begin(), {"'" + std::string(spelling(keyword)) + "' was opened at",
                                                           session_.files[block.file]->name, where});
      }
    }
    session_.report_fatal(std::move(diagnostic));
  }
  take();
  if (!session_.open_blocks.empty()) session_.open_blocks.pop_back();
}

double Reader::number() { return promoted(session_, evaluate(session_, Level::kAdditive), 1).c[0]; }
int Reader::integer() { return to_int32(number()); }

dvec2 Reader::vector2() {
  const Number value = promoted(session_, evaluate(session_, Level::kAdditive), 2);
  return {value.c[0], value.c[1]};
}

dvec3 Reader::vector() { return promoted(session_, evaluate(session_, Level::kAdditive), 3).vector(); }

dvec4 Reader::vector4() {
  const Number value = promoted(session_, evaluate(session_, Level::kAdditive), 4);
  return {value.c[0], value.c[1], value.c[2], value.c[3]};
}

Number Reader::full_expression(int minimum_count) {
  const Number value = evaluate(session_, Level::kFull);
  return value.count < minimum_count ? promoted(session_, value, minimum_count) : value;
}

Number Reader::additive_expression(int minimum_count) {
  const Number value = evaluate(session_, Level::kAdditive);
  return value.count < minimum_count ? promoted(session_, value, minimum_count) : value;
}

double Reader::condition_number() { return promoted(session_, evaluate(session_, Level::kFull), 1).c[0]; }

bool Reader::at_number() { return starts_number(peek()); }

std::optional<double> Reader::optional_number() {
  const Item& next = peek();
  if (!starts_number(next) || next.is(TokenKind::kLess)) return std::nullopt;
  if (next.is(TokenKind::kIdentifier)) {
    // A vector or colour standing here belongs to the next item.
    const Number* const value = next.slot->get_if<Number>();
    if (value != nullptr && !value->is_float()) return std::nullopt;
  }
  switch (next.word()) {
    case Word::kX: case Word::kY: case Word::kZ: case Word::kU: case Word::kV: case Word::kT: return std::nullopt;
    default: return number();
  }
}

Color Reader::color() { return parse_color(session_, 5).color; }

Rgb Reader::rgb() {
  const Color color = parse_color(session_, 3).color;
  if (color.filter != 0 || color.transmit != 0) {
    const std::string component = color.filter != 0 ? "filter" : "transmit";
    session_.warn("Expected pure RGB color expression, unexpected " + component + " component will have no effect.", "pure-rgb");
  }
  return color.rgb;
}

bool Reader::at_color() { return starts_color(peek()); }

std::u16string Reader::string() { return parse_string(session_); }
std::string Reader::text() { return to_utf8(parse_string(session_)); }
std::string Reader::file_name() { return to_bytes(session_, parse_string(session_, true)); }
bool Reader::at_string() { return starts_string(peek()); }

FunctionPtr Reader::float_function() { return parse_function(session_, FunctionForm::kExpression); }

FunctionPtr Reader::any_function() {
  const std::optional<FunctionPtr> declared = accept_identifier<FunctionPtr>();
  return declared ? *declared : parse_function(session_, FunctionForm::kBody);
}

std::optional<std::string> Reader::find_file(const std::string& name, std::initializer_list<std::string_view> extensions) {
  return find_scene_file(session_, name, extensions);
}

SourceLocation Reader::location() const { return session_.locate(session_.stream.last_file, session_.stream.last_token); }

SourceLocation Reader::next_location() {
  const Item& next = peek();
  return session_.locate(next.file, next.source);
}

void Reader::error(std::string message, std::string code, std::string hint) {
  session_.fail(std::move(message), std::move(code), std::move(hint));
}
void Reader::error_expected(std::string_view what) { session_.fail_expected(what, peek()); }

void Reader::warning(std::string message, int level) {
  if (level == 0 || level < session_.language.version) session_.warn(std::move(message));
}

void Reader::possible_error(std::string message) { session_.possible_error(std::move(message)); }

int Reader::version() const { return session_.language.version; }
int Reader::effective_version() const { return session_.language.version_given ? session_.language.version : 362; }
bool Reader::assumed_gamma_given() const { return session_.language.assumed_gamma_given; }
void Reader::set_assumed_gamma_given() { session_.language.assumed_gamma_given = true; }
void Reader::set_noise_generator_given() { session_.noise_generator_given = true; }
void Reader::set_charset(Charset charset) { session_.language.charset = charset; }

Scene& Reader::scene() { return session_.scene; }
StatementState& Reader::statements() { return *session_.statements; }
GeometryQuery* Reader::geometry() { return session_.options.geometry; }
TextureFunctions* Reader::texture_functions() { return session_.options.texture_functions; }

}  // namespace lute
