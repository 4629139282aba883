// A combination of solids: union that is kept whole, merge, intersection, difference. Source: specification chapter 20 §6.
//
// The builder has already applied `inverse`: the cutters of a difference arrive inverted (leaves marked, unions and merges turned
// into intersections, intersections and differences into merges), and unions that may be split are gone. So are intersections and
// differences without limits of their own inside of others: their children belong to the outer one.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/csg/child_tree.hpp"
#include "engine/csg/leaf_solid.hpp"
#include "engine/csg/recent_refusals.hpp"
#include "engine/csg/solid.hpp"

namespace lute {

enum class CsgKind : std::uint8_t { kUnion, kMerge, kIntersection, kDifference };

// What `inverse` makes of a combination whose children are inverted too (§6.3).
constexpr CsgKind inverted(CsgKind kind) {
  return kind == CsgKind::kUnion || kind == CsgKind::kMerge ? CsgKind::kIntersection : CsgKind::kMerge;
}

// True if a point of the combination is inside of every child.
constexpr bool all_children_needed(CsgKind kind) { return kind == CsgKind::kIntersection || kind == CsgKind::kDifference; }

class CsgSolid final : public Solid {
 public:
  using Children = std::vector<std::unique_ptr<Solid>>;
  // A leaf whose texture contributes to a cut surface, and its share. Shares of one point add up to 1.
  using CutawayShares = std::vector<std::pair<const Leaf*, double>>;

  // Hits are marked with the outermost combination (unions mark only when clipped), so that surfaces which cutaway_textures left
  // without a texture can ask it for theirs.
  CsgSolid(CsgKind kind, Children children, SharedSolids clips = {}, SharedSolids bounds = {});

  CsgKind kind() const { return kind_; }
  const Children& children() const { return children_; }

  void hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const override;
  bool nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const override;
  bool any(const Ray& ray, Interval range, RayKind kind) const override;
  bool inside(const dvec3& point) const override;
  bool plain_inside(const dvec3& point) const override;
  void leaves(std::vector<const Leaf*>& out) const override;
  Aabb hits_within(const Aabb& region) const override;
  Aabb inside_within(const Aabb& region) const override;
  Aabb hits_inside(const Aabb& region) const override;
  Aabb outside_bounds() const override;

  // The textures of an untextured surface point under cutaway_textures (§6.5). Appends nothing where the surface is black. The leaf whose
  // surface the point is `on` counts as inside: what its own test says there is rounding.
  void cutaway_shares(const dvec3& point, const Leaf& on, CutawayShares& out) const;

 private:
  bool all_children_needed() const { return lute::all_children_needed(kind_); }
  // Asking a few children costs no more than remembering which of them refused.
  bool remembers_refusals() const { return children_.size() > 8; }
  bool child_visible(const Solid& child, RayKind kind) const;
  bool survives(std::size_t child, const dvec3& point, RayKind kind, RecentRefusals& recent) const;
  bool refuses(std::size_t i, std::size_t child, const dvec3& point, RayKind kind) const;
  bool in_clips(const dvec3& point) const;
  bool plain_inside_on(const dvec3& point, const Leaf& on) const;
  bool meets_bounds(const Ray& ray) const;
  bool limit(const Ray& ray, Interval& range) const;
  ChildTree set_boxes();
  Aabb narrowed(const Aabb& region) const;
  Aabb child_hits_within(const Solid& child, const Aabb& region) const;
  ChildTree refusals() const;
  bool inside_child(std::size_t child, const dvec3& point) const {
    return leaves_[child] != nullptr ? leaves_[child]->inside_shape(point) : children_[child]->inside(point);
  }
  template <class Sink>
  void hits_of_child(std::size_t child, const Ray& ray, Interval range, RayKind kind, Sink&& sink) const;
  bool nearest_in_union(const Ray& ray, Interval range, RayKind kind, Hit& hit) const;

  CsgKind kind_;
  bool marks_;                   // its mark overwrites that of inner combinations
  bool hides_children_ = false;  // from some kinds of rays
  bool dear_ = false;            // something in it prefers a shorter range
  bool box_cuts_ = false;        // `box` came from the bounds and may be smaller than the content
  Children children_;
  std::vector<const LeafSolid*> leaves_;  // the children that are unclipped leaves, most of them; null for the others
  std::vector<const LeafSolid*> limits_;  // of an intersection: those that narrow the range of a ray for all others
  SharedSolids clips_, bounds_;
  ChildTree tree_;
  ChildTree refusals_;  // of an intersection: the children that may not have a point inside; of many cutters few
};

}  // namespace lute
