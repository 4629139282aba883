#include "engine/shape/plane.hpp"

#include <algorithm>
#include <cmath>

#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;

class HalfSpace final : public ScannedShape<HalfSpace> {
 public:
  HalfSpace(const Plane& plane, const Transform& to_world) {
    normal_ = glm::normalize(plane.normal);
    distance_ = plane.distance;
    if (to_world.identity()) return;
    const dvec3 image = to_world.normal(normal_);
    const double length = glm::length(image);
    normal_ = image / length;
    distance_ = distance_ / length + glm::dot(normal_, to_world.translation);
    // Under a matrix the reference measures the tolerance in object space.
    if (to_world.kinds & Transform::kMatrix) tolerance_ = kEpsilon / length;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const double slope = glm::dot(normal_, ray.direction);
    if (std::abs(slope) < kEpsilon) return;
    const double t = (distance_ - glm::dot(normal_, ray.origin)) / slope;
    if (t <= kMaxDepth) sink(t, 0);
  }

  Aabb bounds() const override { return Aabb::infinite(); }
  Aabb inside_bounds() const override {
    Aabb box = Aabb::infinite();
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(normal_[(axis + 1) % 3]) > kEpsilon || std::abs(normal_[(axis + 2) % 3]) > kEpsilon) continue;
      (normal_[axis] > 0 ? box.hi : box.lo)[axis] = distance_ / normal_[axis];
    }
    return box;
  }
  Aabb surface_within(const Aabb& region) const override { return inside_within(inside_within(region, false), true); }
  // n·p ≤ d limits a coordinate where the region limits the others.
  Aabb inside_within(const Aabb& region, bool inverted) const override {
    const dvec3 n = inverted ? -normal_ : normal_;
    const auto least = [&](int k) {
      const double side = n[k] > 0 ? region.lo[k] : region.hi[k];
      return std::abs(n[k]) <= kEpsilon && !std::isfinite(side) ? 0 : n[k] * side;
    };
    Aabb box = region;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(n[axis]) <= kEpsilon) continue;
      const double rest = least((axis + 1) % 3) + least((axis + 2) % 3);
      const double limit = ((inverted ? -distance_ : distance_) - rest) / n[axis];
      if (n[axis] > 0) {
        box.hi[axis] = std::min(box.hi[axis], limit);
      } else {
        box.lo[axis] = std::max(box.lo[axis], limit);
      }
    }
    return box;
  }
  bool inside(const dvec3& point) const override { return height(point) < tolerance_; }
  bool inside_inverted(const dvec3& point) const override { return -height(point) < tolerance_; }
  dvec3 normal(const ShapeHit&, const dvec3&) const override { return normal_; }
  bool tests_own_box() const override { return false; }
  bool finds_bounds_fast() const override { return true; }
  RayLimits limits_rays() const override { return RayLimits::kAlways; }
  bool limit(const Ray& ray, bool inverted, Interval& range) const override {
    const dvec3& o = ray.origin;
    const double slope = glm::dot(normal_, ray.direction), below = distance_ - glm::dot(normal_, o);
    // Where slopes are smaller, the rounding of a point far out exceeds the margin.
    constexpr double kLeastSlope = 1e-6, kMargin = 1e-9;
    if (std::abs(slope) < kLeastSlope) return true;
    const double margin = tolerance_ + kMargin * (std::abs(distance_) + std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
    const double t = (inverted ? below - margin : below + margin) / slope;
    if ((slope > 0) != inverted) {
      if (t < range.hi) range.hi = t;
    } else {
      if (t > range.lo) range.lo = t;
    }
    return range.lo <= range.hi;
  }

 private:
  double height(const dvec3& point) const { return glm::dot(normal_, point) - distance_; }

  dvec3 normal_{0, 1, 0};
  double distance_ = 0;
  double tolerance_ = kEpsilon;
};

}  // namespace

std::unique_ptr<Shape> build(const Plane& plane, const Transform& to_world, BuildContext&) {
  return std::make_unique<HalfSpace>(plane, to_world);
}

}  // namespace lute
