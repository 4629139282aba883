// cells: one random value for each unit cube
//
// Value: 0...1, the same everywhere in a cube with whole corners; cubes repeat every 4096 units. No parameters.
// Source: specification chapter 50 §6.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Cells : PatternDefaults {
  static constexpr std::string_view kKeyword = "cells";
};

double evaluate(const Cells& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
