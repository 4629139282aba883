#include "engine/texture/pattern/function_pattern.hpp"

#include "engine/function/function.hpp"
#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const FunctionPattern& pattern, const dvec3& p, const PatternContext&) {
  const double value = pattern.function->at(p);
  return value > 1 ? fraction(value) : value;
}

}  // namespace lute
