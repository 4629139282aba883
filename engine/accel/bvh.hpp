// A bounding volume hierarchy with eight children a node, over any items with boxes: the solids of a scene (SceneTree),
// the triangles of a mesh (TriangleTree).
//
// The build is top-down by the surface area heuristic over binned centroids (Wald, "On fast construction of SAH-based
// bounding volume hierarchies", 2007), with subtrees in parallel; its result does not depend on the number of threads.
// Eight children instead of two, whose boxes one vector instruction tests, follow Wald, Benthin and Boulos, "Getting
// rid of packets" (2008).
//
// Boxes are single precision, rounded outward, relative to `origin()`, so that a scene far from its coordinates' origin
// keeps its precision. The traversal (bvh_traversal-inl.hpp) never loses a hit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"

namespace lute {

// How many items a leaf should hold.
struct BvhLeaves {
  std::uint32_t block = 1;  // items tested at once: a leaf costs as many tests as it has (begun) blocks
  std::uint32_t max_size =
      1;  // at least `block`; a leaf of more than one block is made where splitting it would not pay
};

class Bvh {
 public:
  static constexpr std::size_t kWidth = 8;
  static constexpr int kMaxDepth = 48;  // levels of nodes; bounds the stack of the traversal

  struct alignas(64) Node {
    float lo[3][kWidth], hi[3][kWidth];       // [axis][child]; an empty child has lo = +infinity, hi = -infinity
    std::array<std::int32_t, kWidth> child;   // >= 0: node; < 0: leaf whose items begin at ~child
    std::array<std::uint32_t, kWidth> count;  // items of the leaf
  };

  // An item to build over: its box, relative to the tree's origin.
  struct alignas(16) Item {
    float lo[3];
    std::uint32_t index;
    float hi[3];
    std::uint32_t unused = 0;
  };

  Bvh() = default;

  // Over boxes of any scale; sides must be below 1e30. Items with empty boxes are left out.
  explicit Bvh(std::span<const Aabb> boxes, BvhLeaves leaves = {});

  // The same over `count` boxes that nobody keeps: `box_of(i)` is asked twice for each.
  template <class BoxOf>
  Bvh(std::size_t count, const BoxOf& box_of, BvhLeaves leaves = {});

  // Over ready items, origin 0.
  Bvh(std::vector<Item> items, BvhLeaves leaves);

  bool empty() const { return nodes_.empty(); }
  std::span<const Node> nodes() const { return nodes_; }
  const std::array<double, 4>& origin() const { return origin_; }  // the last number is 0, so that four can be loaded at once
  std::span<const std::uint32_t> order() const { return order_; }  // item indices, leaf by leaf
  std::vector<std::uint32_t> take_order() { return std::move(order_); }  // for owners that keep their items in this order
  Aabb bounds() const;

  // Replaces every leaf's (first, count) by what `replace(first, count)` returns, a pair; for owners that repack their
  // items.
  template <class Replace>
  void replace_leaves(Replace&& replace);

  // Visits leaves in order of distance while they begin before `far`. `visit(first, count, far)` tests items
  // order()[first...], may lower `far`, and returns true to end the traversal. `box_tests` counts the visited nodes.
  template <class Visit>
  void traverse(const Ray& ray, Interval range, std::uint64_t& box_tests, Visit&& visit) const {
    visit_leaves(ray, range, box_tests, &visit,
                 [](void* context, std::uint32_t first, std::uint32_t count, double& far) {
                   return (*static_cast<std::remove_reference_t<Visit>*>(context))(first, count, far);
                 });
  }

 private:
  using LeafFunction = bool (*)(void* context, std::uint32_t first, std::uint32_t count, double& far);
  void visit_leaves(const Ray& ray, Interval range, std::uint64_t& box_tests, void* context, LeafFunction visit) const;

  static Item item_of(std::uint32_t index, const Aabb& box, const dvec3& origin);

  std::array<double, 4> origin_{};
  std::vector<Node> nodes_;  // the root first
  std::vector<std::uint32_t> order_;
};

template <class BoxOf>
Bvh::Bvh(std::size_t count, const BoxOf& box_of, BvhLeaves leaves) {
  Aabb all;
  for (std::size_t i = 0; i < count; ++i)
    if (const Aabb box = box_of(i); !box.empty()) all.join(box);
  if (all.empty()) return;
  const dvec3 origin = all.center();
  std::vector<Item> items;
  items.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    if (const Aabb box = box_of(i); !box.empty()) items.push_back(item_of(static_cast<std::uint32_t>(i), box, origin));
  *this = Bvh(std::move(items), leaves);
  origin_ = {origin.x, origin.y, origin.z, 0};
}

template <class Replace>
void Bvh::replace_leaves(Replace&& replace) {
  for (Node& node : nodes_) {
    for (std::size_t c = 0; c < kWidth; ++c) {
      if (node.child[c] >= 0 || node.count[c] == 0) continue;
      const std::pair<std::uint32_t, std::uint32_t> leaf =
          replace(static_cast<std::uint32_t>(~node.child[c]), node.count[c]);
      node.child[c] = ~static_cast<std::int32_t>(leaf.first);
      node.count[c] = leaf.second;
    }
  }
}

}  // namespace lute
