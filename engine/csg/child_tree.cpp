#include "engine/csg/child_tree.hpp"

#include <algorithm>
#include <random>

namespace lute {

ChildTree::ChildTree(std::vector<Aabb> ray_boxes, std::span<const Aabb> all_boxes, std::vector<char> boxed)
    : ray_boxes_(std::move(ray_boxes)), boxed_(std::move(boxed)) {
  any_boxed_ = std::ranges::find(boxed_, true) != boxed_.end();
  constexpr std::size_t kFewest = 8;  // below, a tree costs more than it saves
  std::vector<Aabb> finite(all_boxes.size());  // those left empty stay out of the tree
  std::size_t count = 0;
  for (std::size_t i = 0; i < all_boxes.size(); ++i) {
    if (!all_boxes[i].is_finite()) continue;
    finite[i] = all_boxes[i];
    ++count;
  }
  const bool tree = count >= kFewest;
  for (std::size_t i = 0; i < all_boxes.size(); ++i)
    if (!tree || finite[i].empty()) everywhere_.push_back(static_cast<std::uint32_t>(i));
  if (tree) tree_ = Bvh(finite);
}

void ChildTree::mix_order() { std::ranges::shuffle(everywhere_, std::mt19937(1)); }

}  // namespace lute
