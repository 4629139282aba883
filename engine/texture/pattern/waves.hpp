// waves: circular waves of different frequencies (specification chapter 50 §6, §13.2).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Waves : PatternDefaults {
  static constexpr std::string_view kKeyword = "waves";
};

double evaluate(const Waves& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Waves& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
