// The surface coordinates of the unit sphere that spheres and ovals share. Source: specification chapter 20 §3.
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

// Longitude of (x, z) as a share of a full turn, [0, 1); 0 on the axis.
double longitude_share(double x, double z);

// (longitude, latitude) of the unit vector `q`, each in [0, 1].
dvec2 unit_sphere_uv(const dvec3& q);

}  // namespace lute
