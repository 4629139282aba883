#include <cmath>

#include "engine/light/kinds.hpp"

namespace lute {

LightPath cylinder_path(const BuiltLight& light, const dvec3& point) {
  return {-light.axis, -glm::dot(light.location - point, light.axis)};
}

double cylinder_factor(const BuiltLight& light, const dvec3& point) {
  const dvec3 from_light = point - light.location;
  const double along = glm::dot(from_light, light.axis);
  if (along <= 0) return 0;
  const double from_axis = std::sqrt(std::max(0.0, glm::dot(from_light, from_light) - along * along));
  if (from_axis >= light.falloff) return 0;
  const double q = 1 - from_axis / light.falloff;
  double factor = light.tightness == 0 ? 1 : std::pow(q, light.tightness);
  if (light.radius > 0 && from_axis > light.radius) factor *= smooth_edge(0, 1 - light.radius / light.falloff, q);
  return factor;
}

}  // namespace lute
