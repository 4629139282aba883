#include "engine/light/kinds.hpp"

namespace lute {

LightPath parallel_path(const BuiltLight& light, const dvec3& sample, const LightPath& direct) {
  // Each sample of an area has a direction of its own: toward it from the common point_at.
  const dvec3 back = light.area ? glm::normalize(sample - light.point_at) : -light.axis;
  return {back, direct.distance * glm::dot(back, direct.direction)};
}

}  // namespace lute
