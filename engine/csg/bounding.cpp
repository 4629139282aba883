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

namespace {

// The same for one solid: from its first stretch inside to its last one.
Interval range_inside(const Solid& solid, const Ray& ray, Interval range) {
  thread_local Hits hits;
  const std::size_t first = hits.size();
  solid.hits(ray, range, RayKind{}, hits);
  std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Interval inside{kInfinity, -kInfinity};
  double from = range.lo;
  for (std::size_t i = first; i <= hits.size(); ++i) {
    const double to = i < hits.size() ? hits[i].t : range.hi;
    const double middle = std::isinf(to) ? from + 1 + std::abs(from) : 0.5 * (from + to);
    if (solid.inside(ray.at(middle))) inside = {std::min(inside.lo, from), std::max(inside.hi, to)};
    from = to;
  }
  hits.resize(first);
  return inside;
}

}  // namespace

Interval range_inside_all(const SharedSolids& solids, const Ray& ray, Interval range) {
  for (const auto& solid : solids) {
    const Interval inside = range_inside(*solid, ray, range);
    if (inside.empty()) return inside;
    // Inside tests have tolerances: what lies on a border is theirs to judge.
    constexpr double kSlack = 1e-6;
    range.lo = std::max(range.lo, inside.lo - kSlack * (1 + std::abs(inside.lo)));
    range.hi = std::min(range.hi, inside.hi + kSlack * (1 + std::abs(inside.hi)));
    if (range.empty()) break;
  }
  return range;
}

bool meets_all(const SharedSolids& bounds, const Ray& ray) {
  constexpr Interval kAhead{1e-4, std::numeric_limits<double>::infinity()};
  return std::ranges::all_of(bounds, [&](const auto& bound) {
    if (bound->inside(ray.origin)) return true;
    return (!bound->keeps_box() || meets_box(ray, kAhead, bound->box())) && bound->any(ray, kAhead, RayKind{});
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
    const bool open = open_sides(clip->inside_box()) == 1 && clip->box().is_finite();
    limit = limit.intersection(open ? clip->box() : clip->inside_box());
    any_open |= open;
  }
  if (!any_open || limit.empty() || limit.volume() >= own.volume()) return std::nullopt;
  return limit;
}

bool limit_box(Aabb& box, const SharedSolids& bounds) {
  if (bounds.empty()) return false;
  Aabb limit = Aabb::infinite();
  for (const auto& bound : bounds) limit = limit.intersection(bound->inside_box());
  if (limit.empty() || !limit.is_finite() || limit.volume() >= box.volume()) return false;
  box = limit;
  return true;
}

}  // namespace lute
