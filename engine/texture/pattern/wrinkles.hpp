// wrinkles: ten octaves of noise (specification chapter 50 §6, §13.2).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Wrinkles : PatternDefaults {
  static constexpr std::string_view kKeyword = "wrinkles";
};

double evaluate(const Wrinkles& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Wrinkles& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
