// boxed: 1 at the origin falling to 0 on the cube from -1 to 1
//
// Value: 0...1, 1 - max(|x|, |y|, |z|), 0 outside of the cube. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Boxed : PatternDefaults {
  static constexpr std::string_view kKeyword = "boxed";
};

double evaluate(const Boxed& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
