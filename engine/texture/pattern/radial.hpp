// radial: the angle around the y axis (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Radial : PatternDefaults {
  static constexpr std::string_view kKeyword = "radial";
};

double evaluate(const Radial& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
