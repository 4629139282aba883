#include "engine/texture/pattern/function_pattern.hpp"

#include <cmath>

#include "engine/function/function.hpp"

namespace lute {

double evaluate(const FunctionPattern& pattern, const dvec3& p, const PatternContext&) {
  const double value = pattern.function->at(p);
  return value > 1 ? std::fmod(value, 1.0) : value;
}

}  // namespace lute
