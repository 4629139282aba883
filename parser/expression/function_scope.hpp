// What an expression in function { } can name, and the program that is made of it.
#pragma once

#include <utility>
#include <vector>

#include "engine/function/program.hpp"
#include "parser/session.hpp"

namespace lute {

// A parameter: an undeclared name, or one of x y z u v.
struct FunctionParameter {
  NameId name = 0;
  Word word = Word::kNone;
};

// x, y, z, u or v: they stand for parameters.
inline bool is_coordinate(Word word) {
  return word == Word::kX || word == Word::kY || word == Word::kZ || word == Word::kU || word == Word::kV;
}

struct FunctionScope {
  Session& session;
  ExpressionBuilder builder;
  std::vector<FunctionParameter> parameters;
  std::vector<std::pair<NameId, ExpressionBuilder::Node>> locals;  // of the sums and products that are open
  std::size_t operators = 0;
};

// For the token cursor of the grammar (parser/expression/climb.hpp).
inline Session& session_of(FunctionScope& scope) { return scope.session; }

// Reads an expression up to the token that cannot go on with it. Throws SceneError; ConstantDomainError where a constant part has no
// value.
ExpressionBuilder::Node parse_function_expression(FunctionScope& scope);

}  // namespace lute
