#include "engine/shape/axis_frame.hpp"

#include <cmath>

namespace lute {

void perpendiculars(const dvec3& n, dvec3& u, dvec3& v) {
  // Duff et al., Building an Orthonormal Basis, Revisited (2017).
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  u = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  v = {b, sign + n.y * n.y * a, -n.y};
}

Transform axis_frame(const dvec3& base, const dvec3& axis, double radius) {
  const double length = glm::length(axis);
  const dvec3 unit = axis / length;
  dvec3 u, v;
  perpendiculars(unit, u, v);
  Transform frame;
  frame.linear = dmat3(radius * u, radius * v, axis);
  frame.translation = base;
  frame.inverse_linear = glm::transpose(dmat3(u / radius, v / radius, unit / length));
  frame.inverse_translation = -(frame.inverse_linear * base);
  frame.kinds = Transform::kMatrix;
  return frame;
}

Aabb circle_box(const Transform& frame, double z, double radius) {
  const dvec3 center = frame.point({0, 0, z});
  dvec3 reach;
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] = std::abs(radius) * std::hypot(frame.linear[0][axis], frame.linear[1][axis]);
  return {center - reach, center + reach};
}

}  // namespace lute
