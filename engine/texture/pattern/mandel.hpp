// mandel iterations { exponent e exterior t, f interior t, f }: steps z^e + c until z escapes
//
// z and c start at x + iy. exponent 2 (default) to 33. Values and the other parameters: engine/texture/pattern/fractal.hpp.
// Source: specification chapter 50 §6.6.
#pragma once

#include "engine/texture/pattern/fractal.hpp"

namespace lute {

struct Mandel : FractalSettings {
  static constexpr std::string_view kKeyword = "mandel";
  int exponent = 2;  // 2...33
};

double evaluate(const Mandel& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
