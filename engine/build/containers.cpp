#include "engine/build/containers.hpp"

#include <algorithm>

namespace lute {
namespace {

constexpr double kLargestSide = 1e30;  // what the tree's single-precision boxes hold

bool fits_tree(const Aabb& box) {
  const dvec3 lo = glm::abs(box.lo), hi = glm::abs(box.hi);
  return std::max({lo.x, lo.y, lo.z, hi.x, hi.y, hi.z}) < kLargestSide;
}

}  // namespace

void Containers::index() {
  std::vector<Aabb> boxes;
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    const Aabb box = all_[i].solid->box();
    if (box.empty()) continue;
    if (fits_tree(box)) {
      boxes.push_back(box);
      in_tree_.push_back(i);
    } else {
      outside_tree_.push_back(i);
    }
  }
  tree_ = Bvh(boxes);
  indexed_ = true;
}

void Containers::find(const dvec3& point, std::vector<const BuiltInterior*>& out) const {
  if (!indexed_) {
    for (const Container& c : all_)
      if (c.holds(point)) out.push_back(c.interior);
    return;
  }
  std::vector<std::uint32_t> found;
  for (const std::uint32_t i : outside_tree_)
    if (all_[i].holds(point)) found.push_back(i);
  // A ray of no length meets the boxes that contain its origin.
  const Ray here{point, glm::normalize(dvec3(1))};
  std::uint64_t visited = 0;
  const auto order = tree_.order();
  tree_.traverse(here, {0, 0}, visited, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t k = first; k < first + count; ++k)
      if (const std::uint32_t i = in_tree_[order[k]]; all_[i].holds(point)) found.push_back(i);
    return false;
  });
  std::ranges::sort(found);
  for (const std::uint32_t i : found) out.push_back(all_[i].interior);
}

}  // namespace lute
