// magnet 1|2 mandel iterations, magnet 1|2 julia <re, im>, iterations { exterior t, f interior t, f }: steps until z escapes or
// comes to rest at 1
//
// The mandel kind starts at 0 with c = x + iy, the julia kind at x + iy with the constant c. Values and the other parameters:
// engine/texture/pattern/fractal.hpp.
// Source: specification chapter 50 §6.6.
#pragma once

#include <optional>

#include "engine/texture/pattern/fractal.hpp"

namespace lute {

struct Magnet : FractalSettings {
  static constexpr std::string_view kKeyword = "magnet";
  int type = 1;               // 1 or 2
  std::optional<dvec2> julia;  // the constant of the julia kind
};

double evaluate(const Magnet& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
