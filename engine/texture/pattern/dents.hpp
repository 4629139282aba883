// dents: noise cubed; as a normal, vector noise scaled by it
//
// Value: 0...1, noise³. Normal: n + amount · noise³ · D(p). No parameters.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Dents : PatternDefaults {
  static constexpr std::string_view kKeyword = "dents";
};

double evaluate(const Dents& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Dents& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
