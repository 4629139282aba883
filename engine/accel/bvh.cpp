#include "engine/accel/bvh.hpp"

#include <cmath>
#include <limits>

#include "engine/accel/bvh_builder.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/accel/bvh.cpp"
#include <hwy/foreach_target.h>

#include "engine/accel/bvh_traversal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace lute::HWY_NAMESPACE {
namespace {

using LeafFunction = bool (*)(void*, std::uint32_t, std::uint32_t, double&);

void visit_leaves(const Bvh& bvh, const Ray& ray, Interval range, std::uint64_t& box_tests, void* context,
                  LeafFunction visit) {
  double far_depth = range.hi;
  traverse<true>(bvh, ray, depth_below(range.lo), depth_above(range.hi), box_tests,
                 [&](std::uint32_t first, std::uint32_t count, float& far) {
                   const double before = far_depth;
                   const bool stop = visit(context, first, count, far_depth);
                   if (far_depth != before) far = depth_above(far_depth);
                   return stop;
                 });
}

}  // namespace
}  // namespace lute::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lute {
namespace {

HWY_EXPORT(visit_leaves);

// The difference of two doubles is rounded too; the margin covers that before it is rounded to single precision.
float rounded_down(double v) {
  v -= std::abs(v) * 0x1p-51;
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float rounded_up(double v) { return -rounded_down(-v); }

}  // namespace

Bvh::Bvh(std::span<const Aabb> boxes, BvhLeaves leaves)
    : Bvh(boxes.size(), [&](std::size_t i) -> const Aabb& { return boxes[i]; }, leaves) {}

Bvh::Item Bvh::item_of(std::uint32_t index, const Aabb& box, const dvec3& origin) {
  Item item;
  item.index = index;
  for (int a = 0; a < 3; ++a) {
    item.lo[a] = rounded_down(box.lo[a] - origin[a]);
    item.hi[a] = rounded_up(box.hi[a] - origin[a]);
  }
  return item;
}

Bvh::Bvh(std::vector<Item> items, BvhLeaves leaves) : nodes_(build_bvh_nodes(items, leaves)) {
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.index);
}

Aabb Bvh::bounds() const {
  Aabb result;
  if (empty()) return result;
  for (std::size_t c = 0; c < kWidth; ++c) {
    const Node& root = nodes_.front();
    if (root.lo[0][c] > root.hi[0][c]) continue;
    for (int a = 0; a < 3; ++a) {
      result.lo[a] = std::min(result.lo[a], static_cast<double>(root.lo[a][c]) + origin_[static_cast<std::size_t>(a)]);
      result.hi[a] = std::max(result.hi[a], static_cast<double>(root.hi[a][c]) + origin_[static_cast<std::size_t>(a)]);
    }
  }
  return result;
}

void Bvh::visit_leaves(const Ray& ray, Interval range, std::uint64_t& box_tests, void* context,
                       LeafFunction visit) const {
  HWY_DYNAMIC_DISPATCH(visit_leaves)(*this, ray, range, box_tests, context, visit);
}

}  // namespace lute
#endif
