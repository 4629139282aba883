// planar: 1 in the x-z plane falling to 0 at distance 1
//
// Value: 0...1, 1 - |y|, 0 farther out. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Planar : PatternDefaults {
  static constexpr std::string_view kKeyword = "planar";
};

double evaluate(const Planar& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
