// spherical: 1 at the origin falling to 0 on the unit sphere
//
// Value: 0...1, 1 - |p|, 0 farther out. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Spherical : PatternDefaults {
  static constexpr std::string_view kKeyword = "spherical";
};

double evaluate(const Spherical& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
