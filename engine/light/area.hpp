// Area lights: the places of their samples. Source: specification chapter 40 §10.4.
#pragma once

#include "engine/light/light.hpp"

namespace lute {

struct AreaAxes {
  dvec3 axis1, axis2;
};

// The axes as a point sees them whose direction to the light's centre is `to_center`: `orient` turns them toward the point.
AreaAxes area_axes(const BuiltLight& light, const dvec3& to_center);

// Of grid place (u, v), 0 to size - 1, jitter already added; from the light's location.
dvec3 area_offset(const AreaLight& area, const AreaAxes& axes, double u, double v);

}  // namespace lute
