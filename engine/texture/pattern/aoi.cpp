#include "engine/texture/pattern/aoi.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/surface_context.hpp"

namespace lute {

double evaluate(const Aoi&, const dvec3&, const PatternContext& context) {
  const SurfaceContext& surface = *context.surface;
  if (!surface.has_surface) return 0;
  return std::acos(std::clamp(glm::dot(glm::normalize(surface.normal), surface.ray_direction), -1.0, 1.0)) / kPi;
}

}  // namespace lute
