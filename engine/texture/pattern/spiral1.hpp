// spiral1 arms: a spiral around the z axis
//
// Value: any number, the phase of engine/texture/pattern/spiral.hpp, made a triangle wave later. arms: 16 bits, may be negative.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Spiral1 : PatternDefaults {
  static constexpr std::string_view kKeyword = "spiral1";
  static constexpr Wave kWave = Wave::kTriangle;
  int arms = 1;
};

double evaluate(const Spiral1& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
