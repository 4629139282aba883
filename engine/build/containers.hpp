// Which solids contain a point: what a camera ray starts in (specification chapter 20 §8.1). A camera whose rays start at many
// places asks it for each of them, so the boxes can be put in a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/accel/bvh.hpp"
#include "engine/csg/solid.hpp"

namespace lute {

struct BuiltInterior;

class Containers {
 public:
  // In scene order. The solid must outlive the list.
  void add(const Solid& solid, const BuiltInterior* interior) { all_.push_back({&solid, interior}); }
  // After the last add(): puts the boxes in a tree, which pays from some questions on.
  void index();

  // Appends the interiors of the solids that contain `point`, in scene order.
  void find(const dvec3& point, std::vector<const BuiltInterior*>& out) const;

 private:
  struct Container {
    const Solid* solid;
    const BuiltInterior* interior;
    bool holds(const dvec3& point) const { return solid->box().contains(point) && solid->plain_inside(point); }
  };

  std::vector<Container> all_;
  std::vector<std::uint32_t> outside_tree_;  // indices of those whose boxes do not fit a tree; all of them without index()
  std::vector<std::uint32_t> in_tree_;       // the tree's items
  Bvh tree_;
  bool indexed_ = false;
};

}  // namespace lute
