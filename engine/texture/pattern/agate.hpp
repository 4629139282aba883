// agate { agate_turb amount }: a sine along z, disturbed by turbulence (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Agate : PatternDefaults {
  static constexpr std::string_view kKeyword = "agate";
  float turbulence = 1;  // agate_turb
};

double evaluate(const Agate& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
