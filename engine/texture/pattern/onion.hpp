// onion: concentric shells around the origin
//
// Value: 0...1, the fractional part of the distance from the origin. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Onion : PatternDefaults {
  static constexpr std::string_view kKeyword = "onion";
};

double evaluate(const Onion& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
