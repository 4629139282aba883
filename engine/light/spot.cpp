#include <cmath>

#include "engine/light/kinds.hpp"

namespace lute {

double spot_factor(const BuiltLight& light, const LightPath& path) {
  double c = glm::dot(path.direction, light.axis);
  if (path.distance > 0) c = -c;
  if (c <= 0) return 0;
  double factor = light.tightness == 0 ? 1 : std::pow(c, light.tightness);
  if (light.cos_radius > 0 && c < light.cos_radius) factor *= smooth_edge(light.cos_falloff, light.cos_radius, c);
  return factor;
}

}  // namespace lute
