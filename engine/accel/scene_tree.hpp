// All solids of a scene, ready for rays. Unbounded solids stand in a list of their own and are asked first; the others
// are in a Bvh, or in the list too where they are only a few.
//
// Of hits at exactly equal depth, that on a solid which the reference calls infinite wins (its box is unbounded or
// larger than 2e10 cubic units), then the one declared first (specification chapter 20 §1, §2.3).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "engine/accel/bvh.hpp"
#include "engine/accel/counters.hpp"
#include "engine/csg/solid.hpp"

namespace lute {

// What stands in the way of light.
enum class Obstruction : std::uint8_t { kNone, kFilter, kOpaque };

// The solid that last stood between a light and some point, asked first for the next point: neighbours have the same
// blocker more often than not. Whether a ray is blocked does not depend on who is asked first.
struct LastBlocker {
  const Solid* solid = nullptr;
  bool unclipped = false;  // an unclipped leaf
  int misses = 0;          // since it last blocked
};

// The surface that a ray leaves: what it meets of this leaf nearer than `clear` is where it starts.
struct Departure {
  const Leaf* leaf = nullptr;
  double clear = 0;
};

class SceneTree {
 public:
  // In scene order. The solids must outlive the tree, and keep their visibility.
  explicit SceneTree(std::span<const Solid* const> solids)
      : SceneTree(solids.size(), [&](std::size_t i) { return solids[i]; }) {}
  explicit SceneTree(std::span<const std::unique_ptr<Solid>> solids)
      : SceneTree(solids.size(), [&](std::size_t i) { return solids[i].get(); }) {}

  bool nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters,
               const Departure& from = {}) const;

  // The nearest hit on a solid that casts shadows.
  bool nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const;

  // kOpaque if an opaque solid that casts shadows is hit anywhere in `range`, else kFilter if any other one is.
  Obstruction obstruction(const Ray& ray, Interval range, LastBlocker& last, Counters& counters) const;

 private:
  struct Entry {
    const Solid* solid;
    std::uint32_t rank;     // of hits at equal depth the lowest wins
    Visibility visibility;  // the solid's own, here so that solids that are left out need not be looked at
    bool unclipped;         // an unclipped leaf: its shape is asked, without the way through the solid
    bool restricted;        // some kinds of rays do not see it
    bool blocks;            // casts shadows and is opaque
  };
  static_assert(sizeof(const Solid*) != 8 || sizeof(Entry) == 16);  // there may be millions of them
  struct Listed {
    Entry entry;
    Aabb box;
    bool boxed;  // the box is worth a test: it is bounded, and the solid costs more than it
  };
  class Best;

  SceneTree(std::size_t count, const std::function<const Solid*(std::size_t)>& solid_at);
  template <class Visit>
  void go_through_list(const Ray& ray, Interval& range, Visit&& visit) const;
  bool blocks(const Entry& entry, const Ray& ray, Interval range, LastBlocker& last, bool& filters, Counters& counters) const;

  std::vector<Listed> listed_;
  std::vector<Entry> bounded_;  // in the order of the tree's leaves
  Bvh bvh_;
  bool any_boxed_ = false;  // in the list
};

}  // namespace lute
