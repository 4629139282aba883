// Boxes around quadrics: f(p) = p·Sp + 2 v·p + c ≤ 0, in world space.
#pragma once

#include "engine/math/aabb.hpp"
#include "engine/shape/quadric.hpp"

namespace lute {

struct QuadraticForm {
  dmat3 s{0.0};  // symmetric
  dvec3 v{0};
  double c = 0;
};

QuadraticForm quadratic_form(const Quadric& quadric);  // in the quadric's own space

// The box around an ellipsoid; infinite for every other quadric.
Aabb ellipsoid_bounds(const Quadric& quadric, const Transform& to_world);

// A box around the points of `region` with f ≤ 0, finite where the slab that the region leaves of the quadric is: a hyperboloid,
// cone or paraboloid between two planes across its axis, an upright cylinder. `far` is a measure of the coordinates, which says
// what rounding leaves of a coefficient that should be zero.
Aabb bounds_within(const QuadraticForm& form, double far, const Aabb& region);

}  // namespace lute
