#include "engine/shape/axis_frame.hpp"

#include <cmath>

namespace lute {

dmat3 turn_z_to(const dvec3& n) {
  const double radial = std::hypot(n.x, n.y);
  const dvec3 k = radial > 0 ? dvec3(-n.y / radial, n.x / radial, 0) : dvec3(1, 0, 0);
  const double angle = std::atan2(radial, n.z);
  const double c = std::cos(angle), s = std::sin(angle);
  dmat3 turn;
  for (int column = 0; column < 3; ++column) {
    dvec3 axis(0);
    axis[column] = 1;
    turn[column] = k[column] * (1 - c) * k + c * axis + s * glm::cross(k, axis);
  }
  return turn;
}

Transform axis_frame(const dvec3& base, const dvec3& axis, double radius) {
  const double length = glm::length(axis);
  const dvec3 unit = axis / length;
  const dmat3 turn = turn_z_to(unit);
  const dvec3 u = turn[0], v = turn[1];
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
