#include "engine/shape/quadric.hpp"

#include <cmath>

#include <glm/matrix.hpp>

#include "engine/math/polynomial.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;

dmat3 symmetric_matrix(const Quadric& q) {
  return {q.squares.x, q.mixed.x / 2, q.mixed.y / 2,  //
          q.mixed.x / 2, q.squares.y, q.mixed.z / 2,  //
          q.mixed.y / 2, q.mixed.z / 2, q.squares.z};
}

// Ellipsoids only. In the quadric's own space c = -S⁻¹v is the centre and k = -f(c); under the linear part M the reach along
// axis i is √(k (M S⁻¹ Mᵀ)ᵢᵢ). It is decided there because a rotation makes the zero determinant of a cylinder or a cone a
// rounding error of either sign.
Aabb ellipsoid_bounds(const Quadric& q, const Transform& to_world) {
  const dmat3 s = symmetric_matrix(q);
  // With mixed terms the determinant itself is rounded, by some 1e-15 of the cube of the trace, and so is the reach.
  const bool exact = q.mixed == dvec3(0);
  const double trace = s[0][0] + s[1][1] + s[2][2];
  const double least = exact ? 0 : 1e-9 * trace * trace * trace;
  const double minor = s[0][0] * s[1][1] - s[0][1] * s[1][0];
  if (!(s[0][0] > 0) || !(minor > 0) || !(glm::determinant(s) > least)) return Aabb::infinite();
  const dmat3 inverse = glm::inverse(s);
  const dvec3 v = 0.5 * q.linear;
  const dvec3 center = -(inverse * v);
  const double k = -(glm::dot(v, center) + q.constant);
  if (!(k >= 0)) return {};
  const dmat3 covariance = to_world.linear * inverse * glm::transpose(to_world.linear);
  const double widen = exact ? 1 : 1 + 1e-5;
  const dvec3 reach = widen * glm::sqrt(k * dvec3(covariance[0][0], covariance[1][1], covariance[2][2]));
  const dvec3 middle = to_world.point(center);
  return {middle - reach, middle + reach};
}

class QuadricSurface final : public ScannedShape<QuadricSurface> {
 public:
  // In world space: p·Sp + 2 v·p + j with the symmetric matrix S.
  QuadricSurface(const Quadric& q, const Transform& to_world) : middle_(to_world.translation), bounds_(ellipsoid_bounds(q, to_world)) {
    const dmat3 s = symmetric_matrix(q);
    const dvec3 v = 0.5 * q.linear;
    const dmat3& m = to_world.inverse_linear;
    const dvec3& o = to_world.inverse_translation;
    square_ = glm::transpose(m) * s * m;
    half_linear_ = glm::transpose(m) * (s * o + v);
    constant_ = glm::dot(o, s * o) + 2 * glm::dot(v, o) + q.constant;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    // About the point nearest to the surface's own origin the coefficients are smallest.
    const double shift = glm::dot(middle_ - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    const dvec3 p = ray.at(shift);
    const dvec3 sd = square_ * ray.direction;
    const std::array<double, 3> c{value(p), 2 * (glm::dot(sd, p) + glm::dot(half_linear_, ray.direction)),
                                  glm::dot(sd, ray.direction)};
    const Interval shifted{range.lo - shift, std::min(range.hi, kMaxDepth) - shift};
    const Roots<2> roots = solve_quadratic(c, shifted);
    for (std::size_t i = roots.count; i-- > 0;) sink(roots.t[i] + shift, 0);
  }

  Aabb bounds() const override { return bounds_; }
  bool inside(const dvec3& point) const override { return value(point) <= 0; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 n = square_ * point + half_linear_;
    const double length = glm::length(n);
    return length > 0 ? n / length : dvec3(1, 0, 0);
  }
  bool inverse_turns_normal() const override { return false; }

 private:
  double value(const dvec3& p) const { return glm::dot(p, square_ * p + 2.0 * half_linear_) + constant_; }

  dmat3 square_{0.0};
  dvec3 half_linear_{0};
  double constant_ = 0;
  dvec3 middle_{0};
  Aabb bounds_;
};

}  // namespace

std::unique_ptr<Shape> build(const Quadric& quadric, const Transform& to_world, BuildContext&) {
  return std::make_unique<QuadricSurface>(quadric, to_world);
}

}  // namespace lute
