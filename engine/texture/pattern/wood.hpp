// wood: rings around the z axis, disturbed by turbulence
//
// Value: 0 and up, the distance from the z axis in a plane that turbulence, where the statement has it, has moved; made a triangle
// wave later. No parameters of its own.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Wood : PatternDefaults {
  static constexpr std::string_view kKeyword = "wood";
  static constexpr Wave kWave = Wave::kTriangle;
  static constexpr bool kOwnTurbulence = true;
};

double evaluate(const Wood& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
