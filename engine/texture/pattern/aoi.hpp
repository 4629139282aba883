// aoi: the angle between ray and surface; 1 head-on, 0.5 grazing (specification chapter 50 §6.7).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Aoi : PatternDefaults {
  static constexpr std::string_view kKeyword = "aoi";
};

double evaluate(const Aoi& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
