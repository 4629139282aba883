// ripples: circular waves from number_of_waves sources (specification chapter 50 §6, §13.2).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Ripples : PatternDefaults {
  static constexpr std::string_view kKeyword = "ripples";
};

double evaluate(const Ripples& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Ripples& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
