// function [(parameters)] { body }: the body is an expression, or wraps a pattern, pigment, transform, spline or internal function.
// Source: specification chapters 10 §11 and 21 §11.
#include <algorithm>

#include "engine/function/enclosure.hpp"
#include "engine/function/internal_function.hpp"
#include "parser/expression/expression.hpp"
#include "parser/expression/function_scope.hpp"

namespace lute {

namespace {

constexpr std::size_t kMostParameters = 56;

std::vector<FunctionParameter> parse_parameters(Session& session) {
  Reader& reader = session.reader;
  std::vector<FunctionParameter> parameters;
  reader.expect(TokenKind::kLeftParen);
  while (!reader.accept(TokenKind::kRightParen)) {
    const Item item = reader.take();
    if (is_coordinate(item.word())) {
      parameters.push_back({0, item.word()});
    } else {
      if (!item.is(TokenKind::kName)) session.fail_expected("parameter identifier", item);
      parameters.push_back({item.token.index, Word::kNone});
    }
    if (parameters.size() > kMostParameters) session.fail("Too many parameters", "function-parameters");
    reader.comma();
  }
  if (parameters.empty()) session.fail("At least one function parameter is required!", "function-parameters");
  return parameters;
}

class TransformFunction final : public Function {
 public:
  explicit TransformFunction(const Transform& transform) : Function(3, 3), transform_(transform) {}
  void evaluate(const double* a, double* results) const override {
    const dvec3 p = transform_.point({a[0], a[1], a[2]});
    results[0] = p.x;
    results[1] = p.y;
    results[2] = p.z;
  }
  bool enclose(const Enclosure* a, Enclosure* results) const override {
    const dmat3& m = transform_.linear;
    for (int k = 0; k < 3; ++k)
      results[k] = m[0][k] * a[0] + m[1][k] * a[1] + m[2][k] * a[2] + transform_.translation[k];
    return true;
  }

 private:
  Transform transform_;
};

class SplineFunction final : public Function {
 public:
  explicit SplineFunction(SplinePtr spline) : Function(1, spline->components), spline_(std::move(spline)) {}
  void evaluate(const double* a, double* results) const override {
    const Spline::Point value = spline_->evaluate(a[0]);
    std::copy_n(value.begin(), result_count(), results);
  }
  bool enclose(const Enclosure* a, Enclosure* results) const override {
    for (std::size_t k = 0; k < static_cast<std::size_t>(result_count()); ++k) results[k] = spline_->enclose(a[0], k);
    return true;
  }

 private:
  SplinePtr spline_;
};

TextureFunctions& texture_functions(Session& session) {
  TextureFunctions* const functions = session.options.texture_functions;
  if (functions == nullptr) session.fail("Pigment and pattern functions need the engine, which is not connected.", "no-textures");
  return *functions;
}

template <class T>
T statement_value(Session& session, Word word) {
  const auto found = session.declare_values.find(word);
  if (found == session.declare_values.end()) session.fail_expected("operand", session.stream.peek());
  const Value value = found->second(session.reader);
  const T* const result = value.get_if<T>();
  if (result == nullptr) session.fail("This cannot be used as a function.", "function-body");
  return *result;
}

// The bodies that are no expressions; null if the next token begins none of them.
FunctionPtr parse_special_body(Session& session) {
  const Word word = session.reader.word();
  const int noise_generator = session.scene.settings.noise_generator;
  switch (word) {
    case Word::kPattern: {
      const PigmentPtr pigment = statement_value<PigmentPtr>(session, word);
      return texture_functions(session).pattern_function(pigment->body, noise_generator);
    }
    case Word::kPigment:
      return texture_functions(session).pigment_function(statement_value<PigmentPtr>(session, word), noise_generator);
    case Word::kTransform: return std::make_shared<TransformFunction>(*statement_value<TransformPtr>(session, word));
    case Word::kSpline:
      session.stream.take();
      return std::make_shared<SplineFunction>(parse_spline(session));
    case Word::kInternal: {
      session.stream.take();
      session.reader.expect(TokenKind::kLeftParen);
      const int index = session.reader.integer();
      session.reader.expect(TokenKind::kRightParen);
      FunctionPtr function = internal_function(index, noise_generator);
      if (!function) session.fail("Function 'internal(" + std::to_string(index) + ")' does not exist.", "internal-function");
      return function;
    }
    default: return nullptr;
  }
}

}  // namespace

FunctionPtr parse_function(Session& session, FunctionForm form) {
  const TokenStream::AfterOperand allowed(session.stream, true);
  const ExpressionState::Interruption interruption(session.expressions);
  FunctionScope scope{session, {}, {}, {}, 0};
  const bool listed = form == FunctionForm::kDeclared && session.reader.at(TokenKind::kLeftParen);
  if (listed) {
    scope.parameters = parse_parameters(session);
  } else {
    for (const Word word : {Word::kX, Word::kY, Word::kZ}) scope.parameters.push_back({0, word});
  }
  session.reader.open(Word::kFunction);
  const Word first = session.reader.word();
  FunctionPtr function = form == FunctionForm::kExpression ? nullptr : parse_special_body(session);
  if (function && listed && first != Word::kInternal) {
    session.fail("Function parameters for " + std::string(spelling(first)) + " functions are not allowed.", "function-parameters");
  }
  if (!function) {
    try {
      const ExpressionBuilder::Node root = parse_function_expression(scope);
      // What can follow an operand: the reference names it so.
      if (!session.reader.at(TokenKind::kRightBrace)) session.fail_expected("operator", session.stream.peek());
      function = scope.builder.finish(root, static_cast<int>(scope.parameters.size()));
    } catch (const ConstantDomainError& error) {
      session.fail(error.message, "domain");
    }
  }
  session.reader.close(Word::kFunction);
  if (const std::size_t most = session.options.limits.depth; function->depth() > most) {
    session.fail("Functions call each other too deeply: the limit is " + std::to_string(most) + ".", "limit-depth");
  }
  return function;
}

}  // namespace lute
