// Whether a ray passes through a triangle, without gaps at shared edges: the corners are seen from the ray, sheared so that it runs
// along one axis; both triangles at an edge compute the same number for it. Edges and corners belong to the triangle.
// Source: Woop, Benthin, Wald: Watertight Ray/Triangle Intersection (2013).
#pragma once

#include <array>
#include <cmath>

#include "engine/math/ray.hpp"

namespace lute {

// The shear of one ray, for many triangles.
struct RayShear {
  int i, j, k;  // k: the axis that the ray runs along most
  double shear_i, shear_j;

  explicit RayShear(const dvec3& d) {
    k = 0;
    if (std::abs(d.y) > std::abs(d[k])) k = 1;
    if (std::abs(d.z) > std::abs(d[k])) k = 2;
    i = (k + 1) % 3;
    j = (k + 2) % 3;
    shear_i = d[i] / d[k];
    shear_j = d[j] / d[k];
  }

  // Corners relative to the ray's origin. On success `weights` are the barycentric weights of the corners at the hit.
  bool passes(const dvec3& a, const dvec3& b, const dvec3& c, std::array<double, 3>& weights) const {
    const double ax = a[i] - shear_i * a[k], ay = a[j] - shear_j * a[k];
    const double bx = b[i] - shear_i * b[k], by = b[j] - shear_j * b[k];
    const double cx = c[i] - shear_i * c[k], cy = c[j] - shear_j * c[k];
    const double wa = cx * by - cy * bx;
    const double wb = ax * cy - ay * cx;
    const double wc = bx * ay - by * ax;
    if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) return false;
    const double sum = wa + wb + wc;
    if (sum == 0) return false;
    weights = {wa / sum, wb / sum, wc / sum};
    return true;
  }
};

}  // namespace lute
