// marble: bands along x, disturbed by turbulence
//
// Value: x, plus turbulence times its amount along x where the statement has turbulence; any number, made a triangle wave later.
// No parameters of its own.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Marble : PatternDefaults {
  static constexpr std::string_view kKeyword = "marble";
  static constexpr Wave kWave = Wave::kTriangle;
  static constexpr bool kOwnTurbulence = true;
};

double evaluate(const Marble& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
