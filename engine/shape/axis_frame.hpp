// Frames of shapes that are round about an axis: a canonical shape along +z from the origin to z = 1 with radius 1 is carried to
// its place. Source: specification chapter 20 §5.
#pragma once

#include "engine/math/transform.hpp"

namespace lute {

// Carries z = 0 to `base`, z = 1 to `base + axis`, and the unit circle to one of `radius` about the axis. `axis` and `radius` must
// not be zero.
Transform axis_frame(const dvec3& base, const dvec3& axis, double radius);

// The rotation that carries z to the unit vector `n`, about the axis and with the rounding of POV-Ray's: an axis in the x-y plane gets
// a z of 6e-17. Scenes print the normals that `trace` gives, and there it is the difference between 0.00 and -0.00.
dmat3 turn_z_to(const dvec3& n);

// Box around a disc: the image under `frame` of the circle of `radius` about the z axis at height z.
Aabb circle_box(const Transform& frame, double z, double radius);

}  // namespace lute
