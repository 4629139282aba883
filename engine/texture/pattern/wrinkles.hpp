// wrinkles: ten octaves of noise
//
// Value: 0...1, half the sum of noise(2^i p) / 2^i. Normal: n + amount · Σ |D(2^i p)| / 2^i. No parameters.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Wrinkles : PatternDefaults {
  static constexpr std::string_view kKeyword = "wrinkles";
};

double evaluate(const Wrinkles& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Wrinkles& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
