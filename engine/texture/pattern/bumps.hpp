// bumps: plain noise; as a normal, vector noise
//
// Value: the noise at the point, 0...1. Normal: n + amount · D(p). No parameters.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Bumps : PatternDefaults {
  static constexpr std::string_view kKeyword = "bumps";
};

double evaluate(const Bumps& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Bumps& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
