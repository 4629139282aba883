#include "engine/light/light.hpp"

#include <cmath>

#include "engine/light/kinds.hpp"

namespace lute {

BuiltLight build_light(const LightSource& d, const Transform& to_world, bool area_lights) {
  BuiltLight light;
  light.kind = d.kind;
  light.parallel = d.parallel;
  light.location = to_world.point(d.location);
  light.point_at = to_world.point(d.point_at);
  // The direction is taken in the light's own space and moved as a direction.
  const dvec3 axis = to_world.direction(d.point_at - d.location);
  const double length = glm::length(axis);
  light.axis = length > 0 ? axis / length : dvec3(0, 0, 1);
  light.color = d.color;
  light.radius = d.radius;
  light.falloff = d.falloff;
  light.tightness = d.tightness;
  light.cos_radius = std::cos(radians(d.radius));
  light.cos_falloff = std::cos(radians(d.falloff));
  light.fade_distance = d.fade_distance;
  light.fade_power = d.fade_power;
  light.fades = d.fade_power > 0 && std::abs(d.fade_distance) > kEpsilon;
  if (d.area && area_lights) {
    light.area = d.area;
    light.area->axis1 = to_world.direction(d.area->axis1);
    light.area->axis2 = to_world.direction(d.area->axis2);
    light.axis1_length = glm::length(light.area->axis1);
    light.axis2_length = glm::length(light.area->axis2);
  }
  light.media_attenuation = d.media_attenuation;
  light.media_interaction = d.media_interaction;
  light.where = d.where;
  return light;
}

LightPath path_of_kind(const BuiltLight& light, const dvec3& sample, const dvec3& point) {
  if (light.kind == LightKind::kCylinder) return cylinder_path(light, point);
  const LightPath direct = point_path(sample, point);
  return light.parallel ? parallel_path(light, sample, direct) : direct;
}

double attenuation(const BuiltLight& light, const dvec3& point, const LightPath& path) {
  double factor = 1;
  if (light.kind == LightKind::kSpot)
    factor = spot_factor(light, path);
  else if (light.kind == LightKind::kCylinder)
    factor = cylinder_factor(light, point);
  if (light.fades) factor *= fade_factor(light, path.distance);
  return factor;
}

double smooth_edge(double lo, double hi, double v) {
  if (v < lo) return 0;
  if (v >= hi) return 1;
  const double y = (v - lo) / (hi - lo);
  return y * y * (3 - 2 * y);
}

double fade_factor(const BuiltLight& light, double distance) {
  return 2 / (1 + std::pow(distance / light.fade_distance, light.fade_power));
}

}  // namespace lute
