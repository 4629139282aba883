#include "engine/shape/disc.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;

class FlatDisc final : public ScannedShape<FlatDisc> {
 public:
  FlatDisc(const Disc& disc, const SharedTransform& to_world)
      : radius2_(disc.radius * disc.radius), hole2_(disc.hole_radius * disc.hole_radius), radius_(disc.radius) {
    const double length = glm::length(disc.normal);
    if (length == 0) {
      radius2_ = -1;  // nothing lies within
      return;
    }
    const Transform frame = axis_frame(disc.center, disc.normal / length, 1);
    to_world_ = to_world.identity() ? frame : frame.then(to_world);
    const dvec3 n = to_world_->normal({0, 0, 1});
    normal_ = glm::normalize(n);
    center_ = to_world_->translation;
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const double slope = glm::dot(normal_, ray.direction);
    if (std::abs(slope) < kEpsilon) return;
    const double t = glm::dot(normal_, center_ - ray.origin) / slope;
    if (!(t < kMaxDepth)) return;
    const dvec3 p = to_world_->inverse_direction(ray.at(t) - center_);
    const double distance2 = p.x * p.x + p.y * p.y;
    if (distance2 <= radius2_ && distance2 >= hole2_) sink(t, 0);
  }

  Aabb bounds() const override {
    constexpr double kHalfThickness = 1e-3;  // of discs smaller than 1: in their size
    if (radius2_ < 0) return {};
    Aabb box = circle_box(to_world_, 0, radius_);
    const double thickness = kHalfThickness * std::min(1.0, glm::length(box.hi - box.lo));
    box.lo -= thickness * glm::abs(normal_);
    box.hi += thickness * glm::abs(normal_);
    return box;
  }
  Aabb inside_bounds() const override { return Aabb::infinite(); }
  bool inside(const dvec3& point) const override { return radius2_ >= 0 && to_world_->inverse_direction(point - center_).z < 0; }
  dvec3 normal(const ShapeHit&, const dvec3&) const override { return normal_; }

 private:
  double radius2_, hole2_, radius_;
  dvec3 normal_{0, 0, 1}, center_{0};
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Disc& disc, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<FlatDisc>(disc, to_world);
}

}  // namespace lute
