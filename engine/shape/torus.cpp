#include "engine/shape/torus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/root_walk.hpp"
#include "engine/shape/empty_shape.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

bool inside_tube(const Transform& to_world, double major, double minor, const dvec3& point) {
  const dvec3 p = to_world.inverse_point(point);
  const double g = std::hypot(p.x, p.z) - major;
  return g * g + p.y * p.y <= minor * minor;
}

dvec3 normal_of_tube(const Transform& to_world, double major, const dvec3& point) {
  const dvec3 p = to_world.inverse_point(point);
  const double rho = std::hypot(p.x, p.z);
  const dvec3 axis = rho > kEpsilon * std::abs(major) ? dvec3(p.x, 0, p.z) * (major / rho) : dvec3(0);
  return glm::normalize(to_world.normal(p - axis));
}

dvec2 uv_of_tube(const Transform& to_world, double major, const dvec3& point) {
  const dvec3 p = to_world.inverse_point(point);
  const double along = std::atan2(p.y, std::hypot(p.x, p.z) - major);
  return {1 - (std::atan2(p.z, p.x) + kPi) / (2 * kPi), (along + kPi) / (2 * kPi)};
}

class Ring final : public ScannedShape<Ring> {
 public:
  Ring(const Torus& torus, const SharedTransform& to_world)
      : major_(torus.major_radius), minor_(torus.minor_radius), to_world_(to_world) {
    // The stretches are cut a little outside the tube, so that a root at their ends is not lost to rounding.
    const double reach = minor_ * (1 + 1e-9) + major_ * 1e-14;
    outer2_ = (major_ + reach) * (major_ + reach);
    inner_ = major_ - reach;
    height_ = reach;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    Ray local = to_world_.identity() ? ray : to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    Interval stretch{range.lo * length, range.hi * length};
    if (!cut_by_slab(local, stretch)) return;
    const double a = local.direction.x * local.direction.x + local.direction.z * local.direction.z;
    const double b = local.origin.x * local.direction.x + local.origin.z * local.direction.z;
    const double across = local.origin.x * local.direction.z - local.origin.z * local.direction.x;
    if (!cut_by_cylinder(local, a, b, across, stretch)) return;
    const double inner_square = inner_ > 0 ? a * inner_ * inner_ - across * across : -1;
    if (inner_square <= 0 || a == 0) {
      scan_stretch(local, stretch, 1 / length, sink);
      return;
    }
    const double root = std::sqrt(inner_square);
    if (scan_stretch(local, {stretch.lo, std::min(stretch.hi, (-b - root) / a)}, 1 / length, sink)) return;
    scan_stretch(local, {std::max(stretch.lo, (-b + root) / a), stretch.hi}, 1 / length, sink);
  }

  Aabb bounds() const override {
    // Support function of a circle plus that of a ball, along each world axis.
    const dvec3 center = to_world_->translation;
    dvec3 reach;
    for (int axis = 0; axis < 3; ++axis) {
      const dvec3 row(to_world_->linear[0][axis], to_world_->linear[1][axis], to_world_->linear[2][axis]);
      reach[axis] = major_ * std::hypot(row.x, row.z) + minor_ * glm::length(row);
    }
    return {center - reach, center + reach};
  }
  bool inside(const dvec3& point) const override { return inside_tube(*to_world_, major_, minor_, point); }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override { return normal_of_tube(*to_world_, major_, point); }
  dvec2 uv(const ShapeHit&, const dvec3& point) const override { return uv_of_tube(*to_world_, major_, point); }

 private:
  bool cut_by_slab(const Ray& ray, Interval& stretch) const {
    const double dy = ray.direction.y;
    if (dy == 0) return std::abs(ray.origin.y) <= height_;
    double near = (-height_ - ray.origin.y) / dy;
    double far = (height_ - ray.origin.y) / dy;
    if (near > far) std::swap(near, far);
    stretch = {std::max(stretch.lo, near), std::min(stretch.hi, far)};
    return !stretch.empty();
  }

  bool cut_by_cylinder(const Ray& ray, double a, double b, double across, Interval& stretch) const {
    if (a == 0) return ray.origin.x * ray.origin.x + ray.origin.z * ray.origin.z <= outer2_;
    const double square = a * outer2_ - across * across;
    if (!(square >= 0)) return false;
    const double root = std::sqrt(square);
    stretch = {std::max(stretch.lo, (-b - root) / a), std::min(stretch.hi, (-b + root) / a)};
    return !stretch.empty();
  }

  // The roots within one stretch, with the origin moved to its beginning; true if the sink needs no farther ones.
  template <class Sink>
  bool scan_stretch(const Ray& ray, Interval stretch, double scale, Sink& sink) const {
    if (stretch.empty()) return false;
    const dvec3 p = ray.at(stretch.lo);
    const dvec3& d = ray.direction;
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    const double g = rho - major_;
    const double tube = g * g + p.y * p.y - minor_ * minor_;
    const double k1 = g * (rho + major_) + p.y * p.y - minor_ * minor_;
    const double k2 = glm::dot(p, d);
    const double major2 = major_ * major_;
    const std::array<double, 5> c{
        tube * ((rho + major_) * (rho + major_) + p.y * p.y - minor_ * minor_),
        4 * (k2 * k1 + 2 * major2 * p.y * d.y),
        2 * (k1 + 2 * (k2 * k2 + major2 * d.y * d.y)),
        4 * k2,
        1,
    };
    return walk_roots<depth_matters<Sink>()>(c, {0, stretch.hi - stretch.lo}, [&](double root) { return sink((stretch.lo + root) * scale, 0); });
  }

  double major_, minor_;
  double outer2_, inner_, height_;
  SharedTransform to_world_;
};

// Whatever the signs of the radii, the reference computes the whole tube, but only for rays that meet the hollow cylinder
// |y| <= r, max(0, R - r) <= √(x² + z²) <= |R + r|, which holds the tube if R is not negative.
class WindowedRing final : public ScannedShape<WindowedRing> {
 public:
  WindowedRing(const Torus& torus, const SharedTransform& to_world)
      : ring_({std::abs(torus.major_radius), std::abs(torus.minor_radius), false}, to_world),
        major_(torus.major_radius), minor_(torus.minor_radius), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    if (meets_window(to_world_->inverse_ray(ray))) ring_.scan(ray, range, sink);
  }

  Aabb bounds() const override { return ring_.bounds(); }
  bool inside(const dvec3& point) const override { return inside_tube(*to_world_, major_, minor_, point); }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override { return normal_of_tube(*to_world_, major_, point); }
  dvec2 uv(const ShapeHit&, const dvec3& point) const override { return uv_of_tube(*to_world_, major_, point); }

 private:
  bool meets_window(const Ray& ray) const {
    const double inner = std::max(0.0, major_ - minor_), outer = std::abs(major_ + minor_);
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    for (const double y : {-minor_, minor_}) {
      const double t = (y - p.y) / d.y;  // of a level ray infinite or no number
      const double rho = std::hypot(p.x + t * d.x, p.z + t * d.z);
      if (t > 0 && inner <= rho && rho <= outer) return true;
    }
    const double a = d.x * d.x + d.z * d.z, b = p.x * d.x + p.z * d.z, across = p.x * d.z - p.z * d.x;
    for (const double radius : {inner, outer}) {
      const double square = a * radius * radius - across * across;
      if (!(square >= 0) || radius == 0) continue;
      for (const double root : {-std::sqrt(square), std::sqrt(square)}) {
        const double t = (root - b) / a, y = p.y + t * d.y;
        if (t > 0 && -minor_ <= y && y <= minor_) return true;
      }
    }
    return false;
  }

  Ring ring_;
  double major_, minor_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Torus& torus, const SharedTransform& to_world, BuildContext&) {
  const double major = torus.major_radius, minor = torus.minor_radius;
  if (major >= 0 && minor > 0) return std::make_unique<Ring>(torus, to_world);
  if (minor != 0) return std::make_unique<WindowedRing>(torus, to_world);
  return build_empty_shape(false);
}

}  // namespace lute
