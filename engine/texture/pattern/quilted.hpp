// quilted { control0 a control1 b }: padded unit cubes (specification chapter 50 §6, §13.2).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Quilted : PatternDefaults {
  static constexpr std::string_view kKeyword = "quilted";
  static constexpr float kFrequency = 0;
  float control0 = 1, control1 = 1;
};

double evaluate(const Quilted& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Quilted& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
