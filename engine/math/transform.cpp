#include "engine/math/transform.hpp"

#include <cmath>

#include <glm/matrix.hpp>

namespace lute {

Transform Transform::translate(const dvec3& offset) {
  Transform t;
  t.translation = offset;
  t.inverse_translation = -offset;
  t.kinds = kTranslate;
  return t;
}

Transform Transform::rotate(const dvec3& degrees) {
  const auto axis_rotation = [](int a, double angle) {
    const double c = std::cos(radians(angle));
    const double s = std::sin(radians(angle));
    const int b = (a + 1) % 3;
    const int d = (a + 2) % 3;
    dmat3 m(1.0);
    m[b][b] = c;
    m[b][d] = s;  // the image of axis b gains s along axis d: left-handed when x, y, z are drawn left-handed
    m[d][b] = -s;
    m[d][d] = c;
    return m;
  };
  Transform t;
  t.linear = axis_rotation(2, degrees.z) * axis_rotation(1, degrees.y) * axis_rotation(0, degrees.x);
  t.inverse_linear = glm::transpose(t.linear);
  t.kinds = kRotate;
  return t;
}

Transform Transform::scale(const dvec3& factors) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    t.linear[i][i] = factors[i];
    t.inverse_linear[i][i] = 1.0 / factors[i];
    if (factors[i] < 0) t.flips = static_cast<std::uint8_t>(t.flips | 1 << i);
  }
  t.kinds = factors.x == factors.y && factors.y == factors.z ? kUniformScale : kScale;
  return t;
}

Transform Transform::matrix(const dmat3& columns, const dvec3& offset) {
  Transform t;
  t.linear = columns;
  t.translation = offset;
  t.inverse_linear = glm::inverse(columns);
  t.inverse_translation = -(t.inverse_linear * offset);
  t.kinds = kMatrix;
  return t;
}

bool Transform::invertible() const {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!std::isfinite(inverse_linear[i][j])) return false;
  return true;
}

Transform Transform::then(const Transform& next) const {
  if (identity()) return next;
  if (next.identity()) return *this;
  Transform t;
  t.linear = next.linear * linear;
  t.translation = next.linear * translation + next.translation;
  t.inverse_linear = inverse_linear * next.inverse_linear;
  t.inverse_translation = inverse_linear * next.inverse_translation + inverse_translation;
  t.kinds = static_cast<std::uint8_t>(kinds | next.kinds);
  t.flips = kinds & (kRotate | kMatrix) ? flips : static_cast<std::uint8_t>(flips ^ next.flips);
  return t;
}

Transform Transform::inverse() const {
  Transform t = *this;
  std::swap(t.linear, t.inverse_linear);
  std::swap(t.translation, t.inverse_translation);
  t.flips = 0;
  return t;
}

Transform Transform::as_matrix() const {
  Transform t = *this;
  t.kinds |= kMatrix;
  t.flips = 0;
  return t;
}

dvec3 Transform::normal(const dvec3& n) const {
  return {glm::dot(inverse_linear[0], n), glm::dot(inverse_linear[1], n), glm::dot(inverse_linear[2], n)};
}

dvec3 Transform::inverse_normal(const dvec3& n) const {
  return {glm::dot(linear[0], n), glm::dot(linear[1], n), glm::dot(linear[2], n)};
}

Aabb Transform::box(const Aabb& b) const {
  if (b.empty() || identity()) return b;
  if (!b.is_finite()) return Aabb::infinite();
  Aabb result;
  for (int corner = 0; corner < 8; ++corner)
    result.join(point({corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y, corner & 4 ? b.hi.z : b.lo.z}));
  return result;
}

}  // namespace lute
