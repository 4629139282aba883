#include "engine/shape/truncated_cone.hpp"

#include <cmath>

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

enum Part : std::uint32_t { kSide, kCap, kBase };

class TruncatedCone final : public ScannedShape<TruncatedCone> {
 public:
  TruncatedCone(const Transform& frame, const dvec3& axis_normal, double taper, bool open)
      : frame_(frame), axis_normal_(axis_normal), taper_(taper), cap_radius2_((1 + taper) * (1 + taper)), open_(open) {}

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const Ray local = frame_.inverse_ray(ray);
    const dvec3& p = local.origin;
    const dvec3& d = local.direction;
    scan_side(p, d, sink);
    if (open_ || std::abs(d.z) <= kEpsilon * glm::length(d)) return;
    const double cap = (1 - p.z) / d.z;
    if (distance2(p, d, cap) <= cap_radius2_) sink(cap, kCap);
    const double base = -p.z / d.z;
    if (distance2(p, d, base) <= 1) sink(base, kBase);
  }

  Aabb bounds() const override {
    Aabb box = circle_box(frame_, 0, 1);
    box.join(circle_box(frame_, 1, 1 + taper_));
    return box;
  }
  bool inside(const dvec3& point) const override {
    // The surface of a closed one is outside, that of an open one inside.
    const double tolerance = open_ ? kEpsilon : -kEpsilon;
    const dvec3 p = frame_.inverse_point(point);
    const double w = 1 + taper_ * p.z;
    return p.x * p.x + p.y * p.y <= w * w + tolerance && -tolerance <= p.z && p.z <= 1 + tolerance;
  }
  dvec3 normal(const ShapeHit& hit, const dvec3& point) const override {
    if (hit.part != kSide) return world_normal({0, 0, hit.part == kCap ? 1 : -1});
    const dvec3 p = frame_.inverse_point(point);
    return world_normal({p.x, p.y, 0 - taper_ * (1 + taper_ * p.z)});  // of a cylinder +0
  }

 private:
  dvec3 world_normal(const dvec3& n) const {
    const dmat3& inverse = frame_.inverse_linear;
    dvec3 sum;
    for (int i = 0; i < 3; ++i) sum[i] = n.x * inverse[i][0] + n.y * inverse[i][1] + n.z * axis_normal_[i];
    return glm::normalize(sum);
  }

  static double distance2(const dvec3& p, const dvec3& d, double t) {
    const double x = p.x + t * d.x;
    const double y = p.y + t * d.y;
    return x * x + y * y;
  }

  // With w = 1 + taper z the side is x² + y² - w² = 0. The discriminant b² - ac is written as a sum of squared cross products,
  // which does not cancel for a distant origin.
  template <class Sink>
  void scan_side(const dvec3& p, const dvec3& d, Sink& sink) const {
    const double pw = 1 + taper_ * p.z;
    const double dw = taper_ * d.z;
    const double xy = p.x * d.y - p.y * d.x;
    const double xw = p.x * dw - pw * d.x;
    const double yw = p.y * dw - pw * d.y;
    const double discriminant = xw * xw + yw * yw - xy * xy;
    if (!(discriminant >= 0)) return;
    const double root = std::sqrt(discriminant);
    const double a = d.x * d.x + d.y * d.y - dw * dw;
    const double b = p.x * d.x + p.y * d.y - pw * dw;
    const auto try_depth = [&](double t) {
      const double z = p.z + t * d.z;
      if (z >= 0 && z <= 1) sink(t, kSide);
    };
    if (taper_ == 0) {
      // Both roots have the same relative error here, which keeps a rim symmetric.
      if (!(a > kEpsilon * glm::dot(d, d))) return;
      try_depth((root - b) / a);
      try_depth((-root - b) / a);
      return;
    }
    const double c = p.x * p.x + p.y * p.y - pw * pw;
    const double q = b > 0 ? -(b + root) : root - b;
    try_depth(c / q);
    if (a != 0) try_depth(q / a);
  }

  Transform frame_;
  dvec3 axis_normal_;
  double taper_, cap_radius2_;
  bool open_;
};

}  // namespace

std::unique_ptr<Shape> build_truncated_cone(const Transform& frame, const dvec3& axis_normal, double taper, bool open) {
  return std::make_unique<TruncatedCone>(frame, axis_normal, taper, open);
}

}  // namespace lute
