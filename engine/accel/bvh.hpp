// A bounding volume hierarchy with four children a node, over any items with boxes.
//
// Built top-down with the surface area heuristic over binned centroids (Wald, "On fast construction of SAH-based bounding volume
// hierarchies", 2007), then collapsed to four children. The boxes are single precision, rounded outward, and the slab test widens its
// exit distances by the error bound of Ize, "Robust BVH ray traversal" (2013), so that no hit is ever lost. The four boxes of a node lie side
// by side, for the compiler to test them at once.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"

namespace lute {

class Bvh {
 public:
  struct alignas(64) Node {
    float lo[3][4], hi[3][4];          // [axis][child]; an empty child has lo > hi
    std::array<std::int32_t, 4> child; // >= 0: node; < 0: leaf, items from ~child
    std::array<std::uint32_t, 4> count;// items of a leaf
  };

  // Boxes must be finite. Items with empty boxes are left out. Deterministic.
  explicit Bvh(std::span<const Aabb> boxes, std::uint32_t leaf_size = 2);
  Bvh() = default;

  bool empty() const { return nodes_.empty(); }
  std::span<const std::uint32_t> order() const { return order_; }  // item indices, leaf by leaf

  // Visits leaves in order of distance while they begin before `far`. `visit(first, count, far)` tests items order()[first...], may lower
  // `far`, and returns true to end the traversal.
  template <class Visit>
  void traverse(const Ray& ray, Interval range, std::uint64_t& box_tests, Visit&& visit) const;

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  friend class BvhBuilder;
};

namespace detail {

// The ray as the slab test wants it: reciprocals, with zeros kept away from 0 * infinity.
struct SlabRay {
  double origin[3], reciprocal[3];
  explicit SlabRay(const Ray& ray) {
    for (int a = 0; a < 3; ++a) {
      origin[a] = ray.origin[a];
      double d = ray.direction[a];
      // A component too small to invert moves the ray by nothing that a box could tell; its sign is kept.
      if (std::fabs(d) < 1e-200) d = std::copysign(1e-200, d);
      reciprocal[a] = 1.0 / d;
    }
  }
};

}  // namespace detail

template <class Visit>
void Bvh::traverse(const Ray& ray, Interval range, std::uint64_t& box_tests, Visit&& visit) const {
  if (nodes_.empty()) return;
  const detail::SlabRay slab(ray);
  struct Pending {
    double distance;
    std::int32_t child;
    std::uint32_t count;
  };
  // A node leaves at most three siblings behind; depth is bounded by the build (kMaxDepth levels).
  std::array<Pending, 256> stack;
  std::size_t top = 0;
  double far = range.hi;
  stack[top++] = {range.lo, 0, 0};
  while (top > 0) {
    const Pending next = stack[--top];
    if (next.distance > far) continue;
    if (next.child < 0) {
      if (visit(static_cast<std::uint32_t>(~next.child), next.count, far)) return;
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(next.child)];
    ++box_tests;
    double entry[4], exit[4];
    for (int c = 0; c < 4; ++c) {
      entry[c] = range.lo;
      exit[c] = far;
    }
    for (int a = 0; a < 3; ++a) {
      const double o = slab.origin[a], r = slab.reciprocal[a];
      const float* nearer = r < 0 ? node.hi[a] : node.lo[a];
      const float* farther = r < 0 ? node.lo[a] : node.hi[a];
      for (int c = 0; c < 4; ++c) {
        const double t0 = (static_cast<double>(nearer[c]) - o) * r;
        const double t1 = (static_cast<double>(farther[c]) - o) * r * (1 + 4 * std::numeric_limits<double>::epsilon());
        entry[c] = t0 > entry[c] ? t0 : entry[c];
        exit[c] = t1 < exit[c] ? t1 : exit[c];
      }
    }
    // Nearest child last onto the stack: it is popped first.
    const std::size_t base = top;
    for (int c = 0; c < 4; ++c) {
      if (!(entry[c] * (1 - 4 * std::numeric_limits<double>::epsilon()) <= exit[c])) continue;
      if (node.lo[0][c] > node.hi[0][c]) continue;
      std::size_t at = top++;
      for (; at > base && stack[at - 1].distance < entry[c]; --at) stack[at] = stack[at - 1];
      stack[at] = {entry[c], node.child[static_cast<std::size_t>(c)], node.count[static_cast<std::size_t>(c)]};
    }
  }
}

}  // namespace lute
