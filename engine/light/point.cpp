#include "engine/light/kinds.hpp"

namespace lute {

LightPath point_path(const dvec3& sample, const dvec3& point) {
  const dvec3 to_light = sample - point;
  const double distance = glm::length(to_light);
  return {distance > 0 ? to_light / distance : to_light, distance};
}

}  // namespace lute
