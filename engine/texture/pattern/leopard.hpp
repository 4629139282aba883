// leopard: squared mean of three sines
//
// Value: 0...1, ((sin x + sin y + sin z) / 3)², angles in radians. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Leopard : PatternDefaults {
  static constexpr std::string_view kKeyword = "leopard";
};

double evaluate(const Leopard& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
