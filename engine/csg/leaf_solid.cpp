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

LeafSolid::LeafSolid(Leaf leaf, SharedSolids clips, SharedSolids bounds, BoundTest bound_test, bool box_tested)
    : inverted_(leaf.inverted), patch_(leaf.shape->is_patch()), leaf_(std::move(leaf)) {
  if (!shape().inverse_turns_normal()) leaf_.inverted = false;
  opaque = leaf_.opaque;
  if (!clips.empty() || !bounds.empty()) {
    set_limits(std::move(clips), std::move(bounds), bound_test, box_tested);
  } else if (!shape().finds_bounds_fast()) {
    auto boxes = std::make_unique<Boxes>();
    boxes->hits = own_box();
    boxes->inside = own_inside_box();
    boxes_ = std::move(boxes);
  }
}

void LeafSolid::set_limits(SharedSolids clips, SharedSolids bounds, BoundTest bound_test, bool box_tested) {
  auto limits = std::make_unique<Limits>();
  const Aabb clipped = inside_all_within(clips, Aabb::infinite());
  Aabb& box = limits->hits;
  box = clips.empty() ? shape().bounds() : widened(shape().surface_within(clipped)).intersection(clipped);
  limits->box_cuts = limit_box(box, bounds);
  if (const auto limit = closing_box(clips, limits->box_cuts ? box : shape().bounds()); limit && box_tested) {
    box = shape().bounds().is_finite() ? *limit : widened(shape().surface_within(*limit)).intersection(*limit);
    limits->box_cuts = true;
  }
  limits->inside =
      widened(shape().inside_within(inside_all_within(clips, clipped), inverted_)).intersection(clipped);
  if (shape().obeys_clips()) limits->clips = std::move(clips);
  if (bound_test != BoundTest::kBoxOnly) limits->bounds = std::move(bounds);
  limits->asks_clips_first = shape().prefers_clipped_range() && !limits->clips.empty();
  plain_ = limits->clips.empty() && limits->bounds.empty() && !limits->box_cuts;
  boxes_ = std::move(limits);
}

Aabb LeafSolid::own_box() const { return shape().bounds(); }
Aabb LeafSolid::own_inside_box() const { return widened(shape().inside_within(Aabb::infinite(), inverted_)); }

void LeafSolid::hits(const Ray& ray, Interval range, RayKind, Hits& out) const {
  const SharedSolids* clips = nullptr;
  if (!plain_) {
    const Limits& limit = limits();
    if (limit.box_cuts && !meets_box(ray, {0, range.hi}, limit.hits)) return;
    if (!meets_all(limit.bounds, ray)) return;
    if (limit.asks_clips_first && (range = range_inside_all(limit.clips, ray, range)).empty()) return;
    if (!limit.clips.empty()) clips = &limit.clips;
  }
  thread_local ShapeHits found;
  const std::size_t first = found.size();
  shape().hits(ray, range, found);
  // By index: an inside test of a clip may use the list's tail, and so move it.
  for (std::size_t i = first; i < found.size(); ++i) {
    const ShapeHit shape_hit = found[i];
    const dvec3 point = ray.at(shape_hit.t);
    if (clips == nullptr || inside_all(*clips, point)) out.push_back({shape_hit.t, point, shape_hit, &leaf_, nullptr});
  }
  found.resize(first);
}

bool LeafSolid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (!plain_) return Solid::nearest(ray, range, kind, hit);
  if (!shape().nearest(ray, range, hit.shape_hit)) return false;
  hit.t = hit.shape_hit.t;
  hit.point = ray.at(hit.t);
  hit.leaf = &leaf_;
  hit.cutaway = nullptr;
  return true;
}

bool LeafSolid::any(const Ray& ray, Interval range, RayKind kind) const {
  return plain_ ? shape().any(ray, range) : Solid::any(ray, range, kind);
}

bool LeafSolid::inside(const dvec3& point) const {
  return inside_shape(point) && (plain_ || inside_all(limits().clips, point));
}

bool LeafSolid::plain_inside(const dvec3& point) const { return inside_shape(point); }

Aabb LeafSolid::inside_clips(const Aabb& region) const { return plain_ ? region : inside_all_within(limits().clips, region); }

Aabb LeafSolid::hits_within(const Aabb& region) const {
  const Aabb within = region.intersection(box());
  return widened(shape().surface_within(within)).intersection(within);
}

Aabb LeafSolid::inside_within(const Aabb& region) const {
  const Aabb within = region.intersection(inside_box());
  return widened(shape().inside_within(inside_clips(within), inverted_)).intersection(within);
}

Aabb LeafSolid::outside_bounds() const {
  const bool everywhere = !inverted_ || patch_ || (!plain_ && !limits().clips.empty());
  return everywhere ? Aabb::infinite() : widened(shape().inside_bounds());
}

void LeafSolid::leaves(std::vector<const Leaf*>& out) const { out.push_back(&leaf_); }

}  // namespace lute
