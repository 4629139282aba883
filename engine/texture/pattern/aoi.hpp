// aoi: the angle between ray and surface
//
// Value: 0...1, the angle from normal to ray over π: 1 head-on, 0.5 grazing; 0 where there is no surface (sky, functions). The normal
// is the one perturbed so far. No parameters.
// Source: specification chapter 50 §6.7.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Aoi : PatternDefaults {
  static constexpr std::string_view kKeyword = "aoi";
};

double evaluate(const Aoi& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
