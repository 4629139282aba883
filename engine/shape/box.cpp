#include "engine/shape/box.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kFarthest = 2e10;
constexpr double kSurface = 1e-12;  // shares of a coordinate, and of the way to the box's own space
constexpr double kGrain = 1e-15;
constexpr double kEdge = 1e-6;  // depths nearer to each other than this meet an edge; for boxes smaller than 1, in their size

// Faces are numbered 2 * axis + (1 at the upper corner).
class SlabBox final : public ScannedShape<SlabBox> {
 public:
  SlabBox(const Box& box, const SharedTransform& to_world) {
    dvec3 a = box.corner_a;
    dvec3 b = box.corner_b;
    if (to_world->kinds & (Transform::kRotate | Transform::kMatrix)) {
      to_world_ = to_world;
      turned_ = true;
    } else if (!to_world.identity()) {
      a = to_world->point(a);
      b = to_world->point(b);
    }
    lo_ = glm::min(a, b);
    hi_ = glm::max(a, b);
    const Aabb world = bounds();
    const dvec3 side = world.hi - world.lo;
    edge_ = kEdge * std::min(1.0, std::max({side.x, side.y, side.z}));
    // A point of the surface counts as inside, also when rounding moved it a little outward.
    const dvec3 margin = kSurface * glm::max(glm::abs(lo_), glm::abs(hi_)) + kGrain * glm::abs(to_world_->inverse_translation);
    solid_ = {lo_ - margin, hi_ + margin};
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const Ray local = turned_ ? to_world_->inverse_ray(ray) : ray;
    Crossing crossing;
    if (!(cross_slab<0>(local, crossing) && cross_slab<1>(local, crossing) && cross_slab<2>(local, crossing))) return;
    if (crossing.near_face != kNone) sink(crossing.near, crossing.near_face);
    if (crossing.far_face != kNone) sink(crossing.far, crossing.far_face);
  }

  Aabb bounds() const override { return to_world_->box({lo_, hi_}); }
  bool inside(const dvec3& point) const override { return solid_.contains(local_point(point)); }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    dvec3 n(0);
    n[static_cast<int>(hit.part / 2)] = hit.part % 2 ? 1 : -1;
    return turned_ ? glm::normalize(to_world_->normal(n)) : n;
  }
  dvec2 uv(const ShapeHit& hit, const dvec3& point) const override {
    dvec3 p = (local_point(point) - lo_) / (hi_ - lo_);
    std::uint32_t face = hit.part;
    if (turned_)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if (!(to_world_->flips >> axis & 1)) continue;
        p[static_cast<int>(axis)] = 1 - p[static_cast<int>(axis)];
        if (face / 2 == axis) face ^= 1;
      }
    switch (face) {
      case 0: return {p.z / 4, 1.0 / 3 + p.y / 3};
      case 1: return {0.75 - p.z / 4, 1.0 / 3 + p.y / 3};
      case 2: return {0.25 + p.x / 4, p.z / 3};
      case 3: return {0.25 + p.x / 4, 1 - p.z / 3};
      case 4: return {1 - p.x / 4, 1.0 / 3 + p.y / 3};
      default: return {0.25 + p.x / 4, 1.0 / 3 + p.y / 3};
    }
  }
  bool tests_own_box() const override { return false; }
  bool finds_bounds_fast() const override { return true; }
  RayLimits limits_rays() const override { return RayLimits::kForDear; }
  bool limit(const Ray& ray, bool inverted, Interval& range) const override {
    if (inverted) return true;
    const Ray local = turned_ ? to_world_->inverse_ray(ray) : ray;
    constexpr double kMargin = 1e-9, kLeastSlope = 1e-6;
    const double size = glm::length(local.direction);
    for (int axis = 0; axis < 3; ++axis) {
      const double p = local.origin[axis], d = local.direction[axis];
      // Where the slope is smaller, the rounding of a point far out exceeds the margin.
      if (std::abs(d) < kLeastSlope * size) continue;
      const double margin = kMargin * (std::abs(p) + std::abs(solid_.lo[axis]) + std::abs(solid_.hi[axis]) + glm::length(local.origin));
      const double a = (solid_.lo[axis] - margin - p) / d, b = (solid_.hi[axis] + margin - p) / d;
      range = {std::max(range.lo, std::min(a, b)), std::min(range.hi, std::max(a, b))};
    }
    return !range.empty();
  }

 private:
  static constexpr std::uint32_t kNone = 6;

  struct Crossing {
    double near = 0, far = kFarthest;
    std::uint32_t near_face = kNone, far_face = kNone;
  };

  dvec3 local_point(const dvec3& point) const { return turned_ ? to_world_->inverse_point(point) : point; }

  // True if the ray runs more along `axis` than along that of the face found before it.
  static bool steeper(const dvec3& d, int axis, std::uint32_t face) {
    return face != kNone && std::abs(d[axis]) > std::abs(d[static_cast<int>(face / 2)]);
  }

  // Cuts the crossing down to one slab; false if nothing is left.
  template <int axis>
  bool cross_slab(const Ray& ray, Crossing& c) const {
    const double p = ray.origin[axis];
    const double d = ray.direction[axis];
    const double edge = axis == 0 ? 0 : edge_;
    constexpr auto lower_face = static_cast<std::uint32_t>(2 * axis);
    if (d == 0) return lo_[axis] <= p && p <= hi_[axis];
    const bool up = d > 0;
    const double enter = ((up ? lo_[axis] : hi_[axis]) - p) / d;
    const double leave = ((up ? hi_[axis] : lo_[axis]) - p) / d;
    if (!(leave >= c.near) || !(enter <= c.far)) return false;
    if (leave <= c.far - edge) {
      c.far = leave;
      c.far_face = lower_face + (up ? 1 : 0);
    } else if (leave <= c.far + edge && steeper(ray.direction, axis, c.far_face)) {
      c.far_face = lower_face + (up ? 1 : 0);
    }
    if (enter >= c.near + edge) {
      c.near = enter;
      c.near_face = lower_face + (up ? 0 : 1);
    } else if (enter >= c.near - edge && steeper(ray.direction, axis, c.near_face)) {
      c.near_face = lower_face + (up ? 0 : 1);
    }
    return true;
  }

  dvec3 lo_{0}, hi_{1};
  Aabb solid_;  // with the margin of the inside test
  double edge_ = kEdge;
  bool turned_ = false;
  SharedTransform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Box& box, const SharedTransform& to_world, BuildContext&) {
  return std::make_unique<SlabBox>(box, to_world);
}

}  // namespace lute
