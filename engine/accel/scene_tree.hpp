// All solids of a scene, ready for rays. Unbounded solids stand in a list of their own and are asked first; the others
// are in a Bvh.
//
// Of hits at exactly equal depth, that on a solid which the reference calls infinite wins (its box is unbounded or
// larger than 2e10 cubic units), then the one declared first (specification chapter 20 §1, §2.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/accel/bvh.hpp"
#include "engine/accel/counters.hpp"
#include "engine/csg/solid.hpp"

namespace lute {

class SceneTree {
 public:
  // In scene order. The solids must outlive the tree, and keep their visibility.
  explicit SceneTree(std::span<const Solid* const> solids);

  bool nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters) const;

  // The nearest hit on a solid that casts shadows.
  bool nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const;

  // True if an opaque solid that casts shadows is hit anywhere in `range`.
  bool any_opaque(const Ray& ray, Interval range, Counters& counters) const;

 private:
  struct Entry {
    const Solid* solid;
    std::uint32_t rank;     // of hits at equal depth the lowest wins
    Visibility visibility;  // the solid's own, here so that solids that are left out need not be looked at
    bool blocks;            // casts shadows and is opaque
  };
  struct Best;

  std::vector<Entry> unbounded_, bounded_;  // bounded_ in the order of the tree's leaves
  Bvh bvh_;
};

}  // namespace lute
