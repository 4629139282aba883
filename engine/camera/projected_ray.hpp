// A camera's ray before its direction is normalised: focal blur needs the length.
#pragma once

#include <limits>

#include "engine/math/vec.hpp"

namespace lute {

struct ProjectedRay {
  dvec3 origin{0};
  dvec3 direction{0, 0, 1};
  dvec2 pattern_point{0};  // where the camera's `normal` is evaluated (chapter 30 §3.3)
  double reach = std::numeric_limits<double>::infinity();  // hits from this distance on do not count
};

}  // namespace lute
