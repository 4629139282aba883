// Finds the few of many parts of a combination that a ray or a point can concern. A handful of parts is simply gone through.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/accel/bvh.hpp"
#include "engine/csg/bounding.hpp"

namespace lute {

class ChildTree {
 public:
  // `ray_boxes`: where a ray has to pass to hit a child. `all_boxes`: where a point may be inside it, or a ray hit it.
  // `boxed`: the child costs more than a test of its box. (Bytes: they are read faster than bits.)
  ChildTree(std::vector<Aabb> ray_boxes, std::span<const Aabb> all_boxes, std::vector<char> boxed);

  // Mixes the order in which the children outside the tree are visited by around(): of many that may answer, one that does is then
  // found soon in the mean, however the children were declared.
  void mix_order();

  // Calls visit(child, far) for the children that the ray may hit before `far`, which visit may lower; nearer boxes first where
  // there is a tree, else in order. `visit` returns true to end.
  template <class Visit>
  void along(const Ray& ray, Interval range, Visit&& visit) const {
    double far = range.hi;
    if (!any_boxed_ && tree_.empty()) {
      for (const std::uint32_t child : everywhere_)
        if (visit(child, far)) return;
      return;
    }
    std::uint64_t box_tests = 0;
    const BoxTest boxes(ray);
    bool done = false;
    const auto try_child = [&](std::uint32_t child) {
      if (!done && (!boxed_[child] || boxes.meets({range.lo, far}, ray_boxes_[child]))) done = visit(child, far);
    };
    for (const std::uint32_t child : everywhere_) try_child(child);
    if (done || tree_.empty()) return;
    const auto order = tree_.order();
    tree_.traverse(ray, {range.lo, far}, box_tests, [&](std::uint32_t first, std::uint32_t count, double& tree_far) {
      for (std::uint32_t i = first; i < first + count; ++i) try_child(order[i]);
      tree_far = std::min(tree_far, far);
      return done;
    });
  }

  // Calls visit(child) for the children that the point may be inside of; `visit` returns true to end.
  template <class Visit>
  void around(const dvec3& point, Visit&& visit) const {
    for (const std::uint32_t child : everywhere_)
      if (visit(child)) return;
    if (tree_.empty()) return;
    std::uint64_t box_tests = 0;
    const auto order = tree_.order();
    tree_.traverse({point, {0, 0, 1}}, {0, 0}, box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
      for (std::uint32_t i = first; i < first + count; ++i)
        if (visit(order[i])) return true;
      return false;
    });
  }

 private:
  std::vector<Aabb> ray_boxes_;
  std::vector<char> boxed_;
  bool any_boxed_ = false;
  std::vector<std::uint32_t> everywhere_;  // not in the tree: unbounded, or too few for one
  Bvh tree_;
};

}  // namespace lute
