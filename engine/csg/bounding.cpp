#include "engine/csg/bounding.hpp"

#include <algorithm>

namespace lute {

bool meets_box(const Ray& ray, Interval range, const Aabb& box) {
  // Widened by a few units in the last place, so that a hit on the box's own surface is never lost.
  constexpr double kWider = 1 + 4 * std::numeric_limits<double>::epsilon();
  double lo = range.lo;
  double hi = range.hi;
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0) {
      if (p < box.lo[axis] || p > box.hi[axis]) return false;
      continue;
    }
    const double inverse = 1 / d;
    double near = (box.lo[axis] - p) * inverse;
    double far = (box.hi[axis] - p) * inverse;
    if (near > far) std::swap(near, far);
    near = near > 0 ? near / kWider : near * kWider;
    far = far > 0 ? far * kWider : far / kWider;
    lo = std::max(lo, near);
    hi = std::min(hi, far);
    if (!(lo <= hi)) return false;
  }
  return true;
}

bool inside_all(const SharedSolids& solids, const dvec3& point) {
  return std::ranges::all_of(solids, [&](const auto& solid) { return solid->inside(point); });
}

bool meets_all(const SharedSolids& bounds, const Ray& ray) {
  constexpr Interval kAhead{1e-4, std::numeric_limits<double>::infinity()};
  return std::ranges::all_of(bounds, [&](const auto& bound) {
    return bound->inside(ray.origin) || (meets_box(ray, kAhead, bound->box) && bound->any(ray, kAhead, RayKind{}));
  });
}

bool limit_box(Aabb& box, const SharedSolids& clips, const SharedSolids& bounds) {
  for (const auto& clip : clips) box = box.intersection(clip->inside_box);
  if (bounds.empty()) return false;
  Aabb limit = Aabb::infinite();
  for (const auto& bound : bounds) limit = limit.intersection(bound->inside_box);
  if (limit.empty() || !limit.is_finite() || limit.volume() >= box.volume()) return false;
  box = limit;
  return true;
}

}  // namespace lute
