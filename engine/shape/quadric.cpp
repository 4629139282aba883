#include "engine/shape/quadric.hpp"

#include <cmath>

#include <glm/matrix.hpp>

#include "engine/math/polynomial.hpp"
#include "engine/shape/quadric_bounds.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;

class QuadricSurface final : public ScannedShape<QuadricSurface> {
 public:
  // In directions of the world, about the place of the surface's own origin: p·Sp + 2 v·p + j with the symmetric matrix S.
  // About the world's origin the coefficients of a surface far away would be too large for its shape.
  QuadricSurface(const Quadric& q, const Transform& to_world)
      : middle_(to_world.translation), bounds_(ellipsoid_bounds(q, to_world)) {
    const auto [s, v, constant] = quadratic_form(q);
    const dmat3& m = to_world.inverse_linear;
    square_ = glm::transpose(m) * s * m;
    half_linear_ = glm::transpose(m) * v;
    constant_ = constant;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    // About the point nearest to the surface's own origin the coefficients are smallest.
    const double shift = glm::dot(middle_ - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    const dvec3 p = ray.at(shift) - middle_;
    const dvec3 sd = square_ * ray.direction;
    const std::array<double, 3> c{value_at(p), 2 * (glm::dot(sd, p) + glm::dot(half_linear_, ray.direction)),
                                  glm::dot(sd, ray.direction)};
    const Interval shifted{range.lo - shift, std::min(range.hi, kMaxDepth) - shift};
    const Roots<2> roots = solve_quadratic(c, shifted);
    for (std::size_t i = roots.count; i-- > 0;) sink(roots.t[i] + shift, 0);
  }

  Aabb bounds() const override { return bounds_; }
  Aabb surface_within(const Aabb& region) const override { return inside_within(region, false); }
  Aabb inside_within(const Aabb& region, bool inverted) const override {
    if (inverted) return region;
    const Aabb about = region.intersection(bounds_);
    const Aabb box = bounds_within({square_, half_linear_, constant_}, glm::length(middle_),
                                   {about.lo - middle_, about.hi - middle_});
    return {box.lo + middle_, box.hi + middle_};
  }
  bool inside(const dvec3& point) const override { return value(point) <= 0; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 n = square_ * (point - middle_) + half_linear_;
    const double length = glm::length(n);
    return length > 0 ? n / length : dvec3(1, 0, 0);
  }
  bool inverse_turns_normal() const override { return false; }

 private:
  double value(const dvec3& point) const { return value_at(point - middle_); }
  double value_at(const dvec3& p) const { return glm::dot(p, square_ * p + 2.0 * half_linear_) + constant_; }

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
