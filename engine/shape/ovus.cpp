#include "engine/shape/ovus.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/root_walk.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/sphere.hpp"
#include "engine/shape/unit_sphere_uv.hpp"

namespace lute {

namespace {

enum Part : std::uint32_t { kBottom, kTop, kJoint };

class Egg final : public ScannedShape<Egg> {
 public:
  Egg(const Ovus& ovus, const SharedTransform& to_world) : bottom_(ovus.bottom_radius), top_(ovus.top_radius), to_world_(to_world) {
    const double b = bottom_;
    const double t = top_;
    if (b > t) {
      joint_ = 2 * b;
      center_y_ = 2 * t - b - t * t / (2 * b);
      ring_ = std::sqrt(b * b - center_y_ * center_y_);
      y_lo_ = -center_y_;
      y_hi_ = (b - center_y_) * t / (joint_ - t) + b;
    } else {
      joint_ = 2 * t;
      center_y_ = -2 * t + b + 1.5 * t * t / b;
      ring_ = std::sqrt(t * t - (center_y_ - b) * (center_y_ - b));
      y_lo_ = -center_y_ * b / (joint_ - b);
      y_hi_ = 2 * b - center_y_;
    }
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    Ray local = to_world_->inverse_ray(ray);
    const double length = glm::length(local.direction);
    local.direction /= length;
    int found = 0;
    const auto on_sphere = [&](double center_y, double radius, std::uint32_t part) {
      const dvec3 w = dvec3(0, center_y, 0) - local.origin;
      const double b = glm::dot(w, local.direction);
      const dvec3 apart = w - b * local.direction;
      const double h = radius * radius - glm::dot(apart, apart);
      if (!(h > 0)) return;
      for (const double t : {b - std::sqrt(h), b + std::sqrt(h)}) {
        const double y = local.origin.y + t * local.direction.y;
        if (!(part == kBottom ? y < y_lo_ : y > y_hi_)) continue;
        sink(t / length, part);
        ++found;
      }
    };
    on_sphere(0, bottom_, kBottom);
    on_sphere(bottom_, top_, kTop);
    if (found < 2) scan_joint(local, length, range, sink);  // an egg is convex
  }

  Aabb bounds() const override {
    const double reach = std::max({bottom_, top_, joint_ - ring_});
    return to_world_->box({{-reach, -bottom_, -reach}, {reach, bottom_ + top_, reach}});
  }
  bool inside(const dvec3& point) const override {
    const dvec3 p = to_world_->inverse_point(point);
    if (glm::length(p) < bottom_ || glm::length(p - dvec3(0, bottom_, 0)) < top_) return true;
    const double r = std::hypot(p.x, p.z) + ring_;
    const double y = p.y - center_y_;
    return p.y > y_lo_ && p.y < y_hi_ && r * r + y * y < joint_ * joint_;
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    dvec3 p = to_world_->inverse_point(point);
    if (hit.part == kTop) p.y -= bottom_;
    if (hit.part == kJoint) {
      const double rho = std::hypot(p.x, p.z);
      const double k = rho > 0 ? 1 + ring_ / rho : 1;
      p = {p.x * k, p.y - center_y_, p.z * k};
    }
    return glm::normalize(to_world_->normal(p));
  }
  dvec2 uv(const ShapeHit&, const dvec3& point) const override {
    return unit_sphere_uv(glm::normalize(to_world_->inverse_point(point) - dvec3(0, top_ / 2, 0)));
  }

 private:
  // (ρ + H)² + (y - V)² = K²: a spindle torus, on its inner sheet. The quartic is set up about the ray's point nearest to its centre.
  template <class Sink>
  void scan_joint(const Ray& ray, double length, Interval range, Sink& sink) const {
    const dvec3 from = ray.origin - dvec3(0, center_y_, 0);
    const dvec3& d = ray.direction;
    Interval within{range.lo * length, range.hi * length};
    if (!cut_to_joint(ray, within)) return;
    const double shift = within.lo;
    const dvec3 p = from + shift * d;
    const double k1 = glm::dot(p, p) - ring_ * ring_ - joint_ * joint_;
    const double k2 = glm::dot(p, d);
    const double r2 = ring_ * ring_;
    const std::array<double, 5> c{k1 * k1 + 4 * r2 * (p.y * p.y - joint_ * joint_), 4 * (k2 * k1 + 2 * r2 * p.y * d.y),
                                  2 * (k1 + 2 * (k2 * k2 + r2 * d.y * d.y)), 4 * k2, 1};
    walk_roots(c, {0, within.hi - shift}, [&](double root) {
      const dvec3 q = p + root * d;
      const double y = q.y + center_y_;
      if (!(y > y_lo_ && y < y_hi_)) return false;
      const double rho = std::hypot(q.x, q.z) + ring_;
      if (!(std::abs(rho * rho + q.y * q.y - joint_ * joint_) < 1e-4 * joint_ * joint_)) return false;
      return sink((root + shift) / length, kJoint);
    });
  }

  // The part of the ray within the slab and the cylinder around the joint, a little widened.
  bool cut_to_joint(const Ray& ray, Interval& within) const {
    const dvec3& d = ray.direction;
    const double slack = 1e-9 * joint_;
    if (d.y != 0) {
      const double t0 = (y_lo_ - slack - ray.origin.y) / d.y, t1 = (y_hi_ + slack - ray.origin.y) / d.y;
      within = {std::max(within.lo, std::min(t0, t1)), std::min(within.hi, std::max(t0, t1))};
    } else if (ray.origin.y < y_lo_ || ray.origin.y > y_hi_) {
      return false;
    }
    const double a = d.x * d.x + d.z * d.z, reach = joint_ - ring_ + slack;
    if (a > 0) {
      const double b = ray.origin.x * d.x + ray.origin.z * d.z, across = ray.origin.x * d.z - ray.origin.z * d.x;
      const double square = a * reach * reach - across * across;
      if (!(square >= 0)) return false;
      const double root = std::sqrt(square);
      within = {std::max(within.lo, (-b - root) / a), std::min(within.hi, (-b + root) / a)};
    }
    return !within.empty() && std::isfinite(within.hi - within.lo);
  }

  double bottom_, top_;
  double joint_ = 0, center_y_ = 0, ring_ = 0;  // K, V, H
  double y_lo_ = 0, y_hi_ = 0;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Ovus& ovus, const SharedTransform& to_world, BuildContext& context) {
  if (ovus.top_radius >= 2 * ovus.bottom_radius)
    return build(Sphere{{0, ovus.bottom_radius, 0}, ovus.top_radius}, to_world, context);
  return std::make_unique<Egg>(ovus, to_world);
}

}  // namespace lute
