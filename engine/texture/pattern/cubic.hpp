// cubic A ... F: six colours by the face of a cube that a direction meets
//
// Value: 0...5 for +x, +y, +z, -x, -y, -z, ties go to the earlier; not processed by frequency, phase and wave. No parameters.
// Source: specification chapter 50 §6.3.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Cubic : PatternDefaults {
  static constexpr std::string_view kKeyword = "cubic";
  static constexpr float kFrequency = 0;
  static constexpr int kListLength = 6;
};

double evaluate(const Cubic& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
