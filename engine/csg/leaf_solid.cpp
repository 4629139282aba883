#include "engine/csg/leaf_solid.hpp"

#include <glm/common.hpp>

#include "engine/csg/bounding.hpp"

namespace lute {

namespace {

// Inside tests have tolerances and boxes are rounded; a box that decides whether to ask has to be a little larger.
Aabb widened(Aabb box) {
  if (box.empty()) return box;
  constexpr double kMargin = 1e-9;
  box.lo -= kMargin * (1.0 + glm::abs(box.lo));
  box.hi += kMargin * (1.0 + glm::abs(box.hi));
  return box;
}

}  // namespace

LeafSolid::LeafSolid(std::unique_ptr<Leaf> leaf, SharedSolids clips, SharedSolids bounds, BoundTest bound_test,
                     bool box_tested)
    : leaf_(std::move(leaf)),
      shape_(leaf_->shape.get()),
      clips_(std::move(clips)),
      bounds_(std::move(bounds)),
      inverted_(leaf_->inverted) {
  if (!shape_->inverse_turns_normal()) leaf_->inverted = false;
  opaque = leaf_->opaque;
  const Aabb clipped = inside_all_within(clips_, Aabb::infinite());
  box = clips_.empty() ? shape_->bounds() : widened(shape_->surface_within(clipped)).intersection(clipped);
  box_cuts_ = limit_box(box, bounds_);
  if (const auto limit = closing_box(clips_, box_cuts_ ? box : shape_->bounds()); limit && box_tested) {
    box = shape_->bounds().is_finite() ? *limit : widened(shape_->surface_within(*limit)).intersection(*limit);
    box_cuts_ = true;
  }
  inside_box = inside_within(clipped);
  if (!shape_->obeys_clips()) clips_.clear();
  if (bound_test == BoundTest::kBoxOnly) bounds_.clear();
  plain_ = clips_.empty() && bounds_.empty() && !box_cuts_;
  patch_ = shape_->is_patch();
  asks_clips_first_ = shape_->prefers_clipped_range() && !clips_.empty();
}

void LeafSolid::hits(const Ray& ray, Interval range, RayKind, Hits& out) const {
  if (!plain_) {
    if (box_cuts_ && !meets_box(ray, {0, range.hi}, box)) return;
    if (!meets_all(bounds_, ray)) return;
    if (asks_clips_first_ && (range = range_inside_all(clips_, ray, range)).empty()) return;
  }
  thread_local ShapeHits found;
  const std::size_t first = found.size();
  shape_->hits(ray, range, found);
  // By index: an inside test of a clip may use the list's tail, and so move it.
  for (std::size_t i = first; i < found.size(); ++i) {
    const ShapeHit shape_hit = found[i];
    const dvec3 point = ray.at(shape_hit.t);
    if (clips_.empty() || inside_all(clips_, point)) out.push_back({shape_hit.t, point, shape_hit, leaf_.get(), nullptr});
  }
  found.resize(first);
}

bool LeafSolid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (!plain_) return Solid::nearest(ray, range, kind, hit);
  if (!shape_->nearest(ray, range, hit.shape_hit)) return false;
  hit.t = hit.shape_hit.t;
  hit.point = ray.at(hit.t);
  hit.leaf = leaf_.get();
  hit.cutaway = nullptr;
  return true;
}

bool LeafSolid::any(const Ray& ray, Interval range, RayKind kind) const {
  return plain_ ? shape_->any(ray, range) : Solid::any(ray, range, kind);
}

bool LeafSolid::inside(const dvec3& point) const {
  return inside_shape(point) && (clips_.empty() || inside_all(clips_, point));
}

bool LeafSolid::plain_inside(const dvec3& point) const { return inside_shape(point); }

Aabb LeafSolid::hits_within(const Aabb& region) const {
  const Aabb limits = region.intersection(box);
  return widened(shape_->surface_within(limits)).intersection(limits);
}

Aabb LeafSolid::inside_within(const Aabb& region) const {
  const Aabb limits = region.intersection(inside_box);
  return widened(shape_->inside_within(inside_all_within(clips_, limits), inverted_)).intersection(limits);
}

Aabb LeafSolid::outside_bounds() const {
  const bool everywhere = !inverted_ || patch_ || !clips_.empty();
  return everywhere ? Aabb::infinite() : widened(shape_->inside_bounds());
}

void LeafSolid::leaves(std::vector<const Leaf*>& out) const { out.push_back(leaf_.get()); }

}  // namespace lute
