#include "engine/texture/pattern/aoi.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double evaluate(const Aoi&, const dvec3&, const PatternContext& context) {
  if (context.normal == dvec3(0)) return 0;
  return std::acos(std::clamp(glm::dot(glm::normalize(context.normal), context.ray_direction), -1.0, 1.0)) / kPi;
}

}  // namespace lute
