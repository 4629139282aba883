#include "engine/shape/quadric_bounds.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/matrix.hpp>

namespace lute {

namespace {

constexpr double kRounded = 1e-14;  // a coefficient this small, relative to the largest, is a zero that was rotated

double largest(const dmat3& s) {
  double result = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result = std::max(result, std::abs(s[i][k]));
  return result;
}

// f becomes its minimum over x_k, a form in the other two coordinates. Needs s_kk > 0.
void minimise_over(int k, QuadraticForm& f) {
  const dvec3 row = f.s[k];
  const double v = f.v[k];
  for (int a = 0; a < 3; ++a) {
    f.v[a] -= row[a] * v / row[k];
    for (int b = 0; b < 3; ++b) f.s[a][b] -= row[a] * row[b] / row[k];
  }
  f.c -= v * v / row[k];
  f.v[k] = 0;
  for (int a = 0; a < 3; ++a) f.s[a][k] = f.s[k][a] = 0;
}

// The least s x² + 2 v x for x in [lo, hi].
double least_on_axis(double s, double v, double lo, double hi) {
  double least = std::min((s * lo + 2 * v) * lo, (s * hi + 2 * v) * hi);
  if (s > 0 && lo * s < -v && -v < hi * s) least = std::min(least, -v * v / s);
  return least;
}

// Narrows one side of the region.
void narrow(int i, QuadraticForm f, double far, Aabb& region) {
  const double scale = largest(f.s);
  bool bounded[3];
  for (int k = 0; k < 3; ++k) bounded[k] = std::isfinite(region.lo[k]) && std::isfinite(region.hi[k]);
  for (int k = 0; k < 3; ++k) {
    if (k == i || bounded[k]) continue;
    if (f.s[k][k] > kRounded * scale) {
      minimise_over(k, f);
    } else if (glm::length(f.s[k]) <= kRounded * scale && std::abs(f.v[k]) <= kRounded * scale * (1 + far)) {
      f.v[k] = 0;  // f does not depend on it: a cylinder's axis
      for (int a = 0; a < 3; ++a) f.s[a][k] = f.s[k][a] = 0;
    } else {
      return;
    }
  }
  const double a = f.s[i][i];
  if (!(a > 1e-9 * scale)) return;
  // a (x + b/a)² ≤ -g, where b is linear in the other coordinates and g the minimum over x.
  double b_lo = f.v[i], b_hi = f.v[i];
  const dvec3 row = f.s[i];
  minimise_over(i, f);
  double g = f.c;
  dvec3 reach(0);
  for (int k = 0; k < 3; ++k) {
    if (k == i || !bounded[k]) continue;
    const auto [lo, hi] = std::minmax({row[k] * region.lo[k], row[k] * region.hi[k]});
    b_lo += lo;
    b_hi += hi;
    reach[k] = std::max(std::abs(region.lo[k]), std::abs(region.hi[k]));
    g += least_on_axis(f.s[k][k], f.v[k], region.lo[k], region.hi[k]);
  }
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  g -= 2 * std::abs(f.s[j][k]) * reach[j] * reach[k];
  const double radius = std::sqrt(std::max(0.0, -g / a));
  region.lo[i] = std::max(region.lo[i], -b_hi / a - radius);
  region.hi[i] = std::min(region.hi[i], -b_lo / a + radius);
}

}  // namespace

QuadraticForm quadratic_form(const Quadric& q) {
  return {dmat3(q.squares.x, q.mixed.x / 2, q.mixed.y / 2,  //
                q.mixed.x / 2, q.squares.y, q.mixed.z / 2,  //
                q.mixed.y / 2, q.mixed.z / 2, q.squares.z),
          0.5 * q.linear, q.constant};
}

// In the quadric's own space c = -S⁻¹v is the centre and k = -f(c); under the linear part M the reach along axis i is
// √(k (M S⁻¹ Mᵀ)ᵢᵢ). It is decided there because a rotation makes the zero determinant of a cylinder or a cone a rounding error of
// either sign.
Aabb ellipsoid_bounds(const Quadric& q, const Transform& to_world) {
  const auto [s, v, constant] = quadratic_form(q);
  // With mixed terms the determinant itself is rounded, by some 1e-15 of the cube of the trace, and so is the reach.
  const bool exact = q.mixed == dvec3(0);
  const double trace = s[0][0] + s[1][1] + s[2][2];
  const double least = exact ? 0 : 1e-9 * trace * trace * trace;
  const double minor = s[0][0] * s[1][1] - s[0][1] * s[1][0];
  if (!(s[0][0] > 0) || !(minor > 0) || !(glm::determinant(s) > least)) return Aabb::infinite();
  const dmat3 inverse = glm::inverse(s);
  const dvec3 center = -(inverse * v);
  const double k = -(glm::dot(v, center) + constant);
  if (!(k >= 0)) return {};
  const dmat3 covariance = to_world.linear * inverse * glm::transpose(to_world.linear);
  const double widen = exact ? 1 : 1 + 1e-5;
  const dvec3 reach = widen * glm::sqrt(k * dvec3(covariance[0][0], covariance[1][1], covariance[2][2]));
  const dvec3 middle = to_world.point(center);
  return {middle - reach, middle + reach};
}

Aabb bounds_within(const QuadraticForm& form, double far, const Aabb& region) {
  Aabb box = region;
  if (box.empty()) return box;
  for (int round = 0; round < 2; ++round)  // what one axis gains may bound the others
    for (int axis = 0; axis < 3; ++axis) narrow(axis, form, far, box);
  return box;
}

}  // namespace lute
