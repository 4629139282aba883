// checker A, B: unit cubes in two colours (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Checker : PatternDefaults {
  static constexpr std::string_view kKeyword = "checker";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 2;
};

double evaluate(const Checker& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
