// cells: one random value for each unit cube (specification chapter 50 §6).
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Cells : PatternDefaults {
  static constexpr std::string_view kKeyword = "cells";
};

double evaluate(const Cells& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
