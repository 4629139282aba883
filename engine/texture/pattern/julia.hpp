// julia <re, im>, iterations { exponent e exterior t, f interior t, f } (specification chapter 50 §6.6).
#pragma once

#include "engine/texture/pattern/fractal.hpp"

namespace lute {

struct Julia : FractalSettings {
  static constexpr std::string_view kKeyword = "julia";
  dvec2 c{0, 0};
  int exponent = 2;  // 2...33
};

double evaluate(const Julia& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
