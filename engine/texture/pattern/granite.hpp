// granite: six octaves of folded noise (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Granite : PatternDefaults {
  static constexpr std::string_view kKeyword = "granite";
};

double evaluate(const Granite& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
