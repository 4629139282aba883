// A solid of one shape, with its clips and bounds. Source: specification chapter 20 §2.2, §3, §7.
//
//   * clips (`clipped_by`): a hit survives if its point is inside all of them; so does the inside test. The cut is left open.
//   * bounds (`bounded_by`): a ray that neither meets a bound nor starts inside it misses the solid as a whole; a bound cuts
//     nothing along the ray. When the boxes of the bounds are smaller than the box of the shape they take its place, even if the
//     shape is larger (§7.3.2): authors see that. They see it of clips too: an object clipped by a height field ends at the lowest
//     ground, though everything below is inside. Not so where rays are not tested against the shape's box (`box_tested`).
#pragma once

#include <memory>
#include <vector>

#include "engine/csg/solid.hpp"

namespace lute {

using SharedSolids = std::vector<std::shared_ptr<const Solid>>;  // shared: clipped_by { bounded_by } uses one list twice

enum class BoundTest {
  kTested,  // rays are tested against the bounds
  kBoxOnly  // the bounds of a plain top-level primitive are dropped, only their box stays in force (§7.2)
};

class LeafSolid final : public Solid {
 public:
  explicit LeafSolid(Leaf leaf, SharedSolids clips = {}, SharedSolids bounds = {},
                     BoundTest bound_test = BoundTest::kTested, bool box_tested = true);

  const Leaf& leaf() const { return leaf_; }
  bool unclipped() const { return plain_; }  // the shape alone decides what is hit, and what is inside
  // Of an unclipped leaf, without the way through the virtual functions of Solid.
  const Shape& shape() const { return *leaf_.shape; }
  bool inside_shape(const dvec3& point) const {
    return !patch_ && (inverted_ ? shape().inside_inverted(point) : shape().inside(point));
  }
  // Whether a hit of another leaf, which lies on this surface, lies where both have the same side of it: not outside counts then.
  bool shares_side(const LeafSolid& other, const dvec3& point) const {
    return !patch_ && inverted_ == other.inverted_ && !(inverted_ ? shape().inside(point) : shape().inside_inverted(point));
  }

  // Of an unclipped leaf: see Shape::limit.
  RayLimits limits_rays() const { return patch_ ? RayLimits::kNever : shape().limits_rays(); }
  bool limit(const Ray& ray, Interval& range) const { return shape().limit(ray, inverted_, range); }

  void hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const override;
  bool nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const override;
  bool any(const Ray& ray, Interval range, RayKind kind) const override;
  bool inside(const dvec3& point) const override;
  bool plain_inside(const dvec3& point) const override;
  void leaves(std::vector<const Leaf*>& out) const override;
  Aabb hits_within(const Aabb& region) const override;
  Aabb inside_within(const Aabb& region) const override;
  Aabb outside_bounds() const override;

 private:
  struct Limits final : Boxes {
    SharedSolids clips, bounds;
    bool asks_clips_first = false;  // for the range in which the shape is searched
    bool box_cuts = false;          // the box came from the bounds and may be smaller than the shape
  };

  Aabb own_box() const override;
  Aabb own_inside_box() const override;
  void set_limits(SharedSolids clips, SharedSolids bounds, BoundTest bound_test, bool box_tested);
  const Limits& limits() const { return static_cast<const Limits&>(*boxes_); }  // unless plain_
  Aabb inside_clips(const Aabb& region) const;

  bool inverted_;  // of the inside test; Leaf::inverted says whether the normal is negated
  bool patch_;
  bool plain_ = true;  // has neither clips nor bounds
  Leaf leaf_;
};
static_assert(sizeof(LeafSolid) <= 72);

}  // namespace lute
