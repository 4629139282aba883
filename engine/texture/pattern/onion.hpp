// onion: concentric shells around the origin (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Onion : PatternDefaults {
  static constexpr std::string_view kKeyword = "onion";
};

double evaluate(const Onion& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
