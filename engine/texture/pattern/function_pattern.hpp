// function { expression in x, y, z }: the expression's value
//
// Value: any number; above 1 only its fractional part counts, below 0 it is wrapped later as that of all patterns.
// Source: specification chapter 50 §6.
#pragma once

#include <memory>

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

class Function;  // engine/function/function.hpp

struct FunctionPattern : PatternDefaults {
  static constexpr std::string_view kKeyword = "function";
  std::shared_ptr<const Function> function;  // of three parameters, one result; never null
};

double evaluate(const FunctionPattern& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
