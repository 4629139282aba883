#include "engine/shape/sphere.hpp"

#include <cmath>

#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/unit_sphere_uv.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;  // in object units
// Rounding, as shares of radius² and of radius times the distance from the world's origin.
constexpr double kSurface = 1e-12, kGrain = 1e-14;
// Up to this squared distance of the origin, in radii, both forms of the chord are equally good. The reference's is then taken: a
// pattern with a step on the very surface (onion on a sphere of radius 1) shows the last bits of the hits.
constexpr double kNear = 1e4;

// Hands both ends of the chord to `sink`, in units of the direction's length 1 / `scale`.
template <class Sink>
void scan_sphere(const dvec3& origin, const dvec3& direction, const dvec3& center, double radius, double scale, Sink& sink) {
  const dvec3 w = center - origin;
  const double b = glm::dot(w, direction);
  const double radius2 = radius * radius;
  const double distance2 = glm::dot(w, w);
  double apart2 = distance2 - b * b;  // of the chord from the centre, squared; to the last bit as the reference has it
  if (distance2 > kNear * radius2) {
    const dvec3 apart = w - b * direction;  // does not cancel
    apart2 = glm::dot(apart, apart);
  }
  const double h = radius2 - apart2;
  if (!(h > 0)) return;
  const double half_chord = std::sqrt(h);
  if (b + half_chord < 0 || b - half_chord > kMaxDepth) return;
  sink((b - half_chord) * scale, 0);
  if (b + half_chord < kMaxDepth) sink((b + half_chord) * scale, 0);
}

// Small, for there may be millions of them.
class RoundSphere : public ScannedShape<RoundSphere> {
 public:
  RoundSphere(const Sphere& sphere, const Transform& to_world) : center_(to_world.point(sphere.center)), radius_(sphere.radius) {
    if (to_world.kinds & Transform::kUniformScale) radius_ *= std::cbrt(std::abs(glm::determinant(to_world.linear)));
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    scan_sphere(ray.origin, ray.direction, center_, radius_, 1, sink);
  }

  Aabb bounds() const override {
    const dvec3 reach(std::abs(radius_));
    return {center_ - reach, center_ + reach};
  }
  bool inside(const dvec3& point) const override {
    const double distance2 = distance2_to(point), radius2 = radius_ * radius_;
    return distance2 < radius2 && distance2 < radius2 - surface();
  }
  bool inside_inverted(const dvec3& point) const override {
    const double distance2 = distance2_to(point), radius2 = radius_ * radius_;
    return distance2 > radius2 && distance2 > radius2 + surface();
  }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override { return (point - center_) / radius_; }
  dvec2 uv(const ShapeHit&, const dvec3& point) const override {
    return unit_sphere_uv(glm::normalize(point - center_));
  }
  bool tests_own_box() const override { return false; }
  bool finds_bounds_fast() const override { return true; }
  RayLimits limits_rays() const override { return RayLimits::kForDear; }
  bool limit(const Ray& ray, bool inverted, Interval& range) const override {
    if (inverted) return true;
    constexpr double kMargin = 1e-9;
    const dvec3& d = ray.direction;
    const dvec3 w = center_ - ray.origin;
    const double b = glm::dot(w, d) / glm::dot(d, d);
    const dvec3 apart = w - b * d;
    const double slack = kMargin * (std::abs(radius_) + glm::length(w) + glm::length(center_)), reach = std::abs(radius_) + slack;
    const double h = reach * reach - glm::dot(apart, apart);
    if (!(h >= 0)) return false;
    const double half = (std::sqrt(h) + slack) / glm::length(d);
    range = {std::max(range.lo, b - half), std::min(range.hi, b + half)};
    return !range.empty();
  }

 protected:
  dvec3 center_;

 private:
  double distance2_to(const dvec3& point) const {
    const dvec3 q = point - center_;
    return glm::dot(q, q);
  }
  // Squared distances this near to radius² are on the surface: neither inside nor outside.
  double surface() const { return kSurface * (radius_ * radius_) + kGrain * glm::length(center_) * std::abs(radius_); }

  double radius_;
};

// A sphere that was moved: uv stays in the space where it was written.
class MovedSphere final : public RoundSphere {
 public:
  MovedSphere(const Sphere& sphere, const SharedTransform& to_world) : RoundSphere(sphere, *to_world), to_world_(to_world) {}
  dvec2 uv(const ShapeHit&, const dvec3& point) const override {
    return unit_sphere_uv(glm::normalize(to_world_->inverse_direction(point - center_)));
  }

 private:
  SharedTransform to_world_;
};

class Ellipsoid final : public ScannedShape<Ellipsoid> {
 public:
  Ellipsoid(const Sphere& sphere, const SharedTransform& to_world) : sphere_(sphere), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const Ray local = to_world_->inverse_ray(ray);
    const double scale = 1 / glm::length(local.direction);
    scan_sphere(local.origin, local.direction * scale, sphere_.center, sphere_.radius, scale, sink);
  }

  Aabb bounds() const override {
    const dvec3 center = to_world_->point(sphere_.center);
    dvec3 reach;  // of the image of the unit sphere along an axis: the length of the matrix's row
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] = std::abs(sphere_.radius) *
                    glm::length(dvec3(to_world_->linear[0][axis], to_world_->linear[1][axis], to_world_->linear[2][axis]));
    return {center - reach, center + reach};
  }
  bool inside(const dvec3& point) const override { return distance2(point) < sphere_.radius * sphere_.radius; }
  bool inside_inverted(const dvec3& point) const override { return distance2(point) > sphere_.radius * sphere_.radius; }
  dvec3 normal(const ShapeHit&, const dvec3& point) const override {
    const dvec3 n = (to_world_->inverse_point(point) - sphere_.center) / sphere_.radius;
    return glm::normalize(to_world_->normal(n));
  }
  dvec2 uv(const ShapeHit&, const dvec3& point) const override {
    return unit_sphere_uv(glm::normalize(to_world_->inverse_point(point) - sphere_.center));
  }
  bool tests_own_box() const override { return false; }
  bool finds_bounds_fast() const override { return true; }

 private:
  double distance2(const dvec3& point) const {
    const dvec3 q = to_world_->inverse_point(point) - sphere_.center;
    return glm::dot(q, q);
  }

  Sphere sphere_;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Sphere& sphere, const SharedTransform& to_world, BuildContext&) {
  if (to_world->kinds & (Transform::kScale | Transform::kMatrix)) return std::make_unique<Ellipsoid>(sphere, to_world);
  if (to_world.identity()) return std::make_unique<RoundSphere>(sphere, *to_world);
  return std::make_unique<MovedSphere>(sphere, to_world);
}

}  // namespace lute
