#include "engine/csg/bounding.hpp"

#include <algorithm>

namespace lute {

bool is_cheap(const Solid& solid) {
  const auto* leaf = dynamic_cast<const LeafSolid*>(&solid);
  return leaf != nullptr && leaf->unclipped() && !leaf->shape().tests_own_box();
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

Aabb inside_all_within(const SharedSolids& solids, Aabb region) {
  for (const auto& solid : solids) region = solid->inside_within(region);
  return region;
}

std::optional<Aabb> closing_box(const SharedSolids& clips, const Aabb& own) {
  const auto open_sides = [](const Aabb& box) {
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) count += std::isinf(box.lo[axis]) + std::isinf(box.hi[axis]);
    return count;
  };
  Aabb limit = Aabb::infinite();
  bool any_open = false;
  for (const auto& clip : clips) {
    const bool open = open_sides(clip->inside_box) == 1 && clip->box.is_finite();
    limit = limit.intersection(open ? clip->box : clip->inside_box);
    any_open |= open;
  }
  if (!any_open || limit.empty() || limit.volume() >= own.volume()) return std::nullopt;
  return limit;
}

bool limit_box(Aabb& box, const SharedSolids& bounds) {
  if (bounds.empty()) return false;
  Aabb limit = Aabb::infinite();
  for (const auto& bound : bounds) limit = limit.intersection(bound->inside_box);
  if (limit.empty() || !limit.is_finite() || limit.volume() >= box.volume()) return false;
  box = limit;
  return true;
}

}  // namespace lute
