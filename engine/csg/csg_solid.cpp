#include "engine/csg/csg_solid.hpp"

#include <algorithm>

#include "engine/csg/bounding.hpp"

namespace lute {

CsgSolid::CsgSolid(CsgKind kind, Children children, SharedSolids clips, SharedSolids bounds)
    : kind_(kind),
      marks_(kind != CsgKind::kUnion || !clips.empty()),
      children_(std::move(children)),
      clips_(std::move(clips)),
      bounds_(std::move(bounds)) {
  opaque = std::ranges::all_of(children_, [](const auto& child) { return child->opaque; });
  child_boxes_.reserve(children_.size());
  for (const auto& child : children_) child_boxes_.push_back(child->box);
  set_boxes();
}

void CsgSolid::set_boxes() {
  Aabb surface;  // of all children
  for (const auto& child : children_) surface.join(child->box);
  if (all_children_needed() && !children_.empty()) {
    inside_box = Aabb::infinite();
    for (const auto& child : children_) inside_box = inside_box.intersection(child->inside_box);
    surface = surface.intersection(inside_box);
    // A hit lies on one child and inside all others, so no child needs to be tried outside this box.
    for (Aabb& child_box : child_boxes_) child_box = child_box.intersection(inside_box);
  } else {
    inside_box = Aabb();
    for (const auto& child : children_) inside_box.join(child->inside_box);
  }
  box = surface;
  box_cuts_ = limit_box(box, clips_, bounds_);
  for (const auto& clip : clips_) inside_box = inside_box.intersection(clip->inside_box);
}

// The flags of the children of an intersection have no effect; those of a union and a merge partly (§6.1): a child's no_shadow
// never, and its no_image not for a primary ray in a union.
bool CsgSolid::child_visible(const Solid& child, RayKind kind) const {
  if (all_children_needed() || kind.shadow) return true;
  Visibility v = child.visibility;
  v.no_shadow = false;
  if (kind_ == CsgKind::kUnion && kind.primary) v.no_image = false;
  return v.visible_to(kind);
}

bool CsgSolid::in_clips(const dvec3& point) const { return inside_all(clips_, point); }

bool CsgSolid::meets_bounds(const Ray& ray) const {
  if (box_cuts_ && !meets_box(ray, {}, box)) return false;
  return meets_all(bounds_, ray);
}

bool CsgSolid::survives(std::size_t child, const dvec3& point, RayKind kind) const {
  if (kind_ == CsgKind::kUnion) return true;
  const bool needed = all_children_needed();
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (i == child) continue;
    const Solid& other = *children_[i];
    if (needed) {
      if (!other.inside(point)) return false;
    } else if (other.inside_box.contains(point) && child_visible(other, kind) && other.inside(point)) {
      return false;
    }
  }
  return true;
}

void CsgSolid::hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const {
  if (!meets_bounds(ray)) return;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const Solid& child = *children_[i];
    if (!child_visible(child, kind) || !meets_box(ray, range, child_boxes_[i])) continue;
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    child.hits(ray, range, kind, out);
    // Last in, first out: among equal depths of one child the order turns around at every level, as in the reference.
    std::reverse(out.begin() + first, out.end());
    const auto dead = [&](const Hit& hit) { return !survives(i, hit.point, kind) || !in_clips(hit.point); };
    out.erase(std::remove_if(out.begin() + first, out.end(), dead), out.end());
    if (!marks_) continue;
    for (auto hit = out.begin() + first; hit != out.end(); ++hit) hit->cutaway = this;
  }
}

bool CsgSolid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (kind_ != CsgKind::kUnion || !clips_.empty()) {
    // Child by child, so that a near hit spares the inside tests of those behind it.
    if (!meets_bounds(ray)) return false;
    thread_local Hits found;
    const std::size_t first = found.size();
    bool any_found = false;
    for (std::size_t i = 0; i < children_.size(); ++i) {
      const Solid& child = *children_[i];
      if (!child_visible(child, kind) || !meets_box(ray, range, child_boxes_[i])) continue;
      child.hits(ray, range, kind, found);
      for (std::size_t k = found.size(); k > first; --k) {
        const Hit candidate = found[k - 1];
        if (candidate.t > range.hi || !survives(i, candidate.point, kind) || !in_clips(candidate.point)) continue;
        hit = candidate;
        range.hi = hit.t;
        any_found = true;
      }
      found.resize(first);
    }
    if (any_found && marks_) hit.cutaway = this;
    return any_found;
  }
  if (!meets_bounds(ray)) return false;
  bool any_found = false;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (!child_visible(*children_[i], kind) || !meets_box(ray, range, child_boxes_[i])) continue;
    Hit candidate;
    if (!children_[i]->nearest(ray, range, kind, candidate)) continue;
    hit = candidate;  // of equal depths the last child wins
    range.hi = hit.t;
    any_found = true;
  }
  return any_found;
}

bool CsgSolid::any(const Ray& ray, Interval range, RayKind kind) const {
  if (kind_ != CsgKind::kUnion || !clips_.empty()) {
    Hit hit;
    return nearest(ray, range, kind, hit);
  }
  if (!meets_bounds(ray)) return false;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (!child_visible(*children_[i], kind) || !meets_box(ray, range, child_boxes_[i])) continue;
    if (children_[i]->any(ray, range, kind)) return true;
  }
  return false;
}

bool CsgSolid::inside(const dvec3& point) const {
  return inside_box.contains(point) && plain_inside(point) && in_clips(point);
}

bool CsgSolid::plain_inside(const dvec3& point) const {
  if (children_.empty()) return false;
  const auto in_child = [&](const auto& child) { return child->inside(point); };
  return all_children_needed() ? std::ranges::all_of(children_, in_child) : std::ranges::any_of(children_, in_child);
}

void CsgSolid::leaves(std::vector<const Leaf*>& out) const {
  for (const auto& child : children_) child->leaves(out);
}

void CsgSolid::cutaway_shares(const dvec3& point, CutawayShares& out) const {
  const std::size_t first = out.size();
  const std::size_t asked = kind_ == CsgKind::kDifference ? std::min<std::size_t>(1, children_.size()) : children_.size();
  for (std::size_t i = 0; i < asked; ++i) {
    if (!children_[i]->plain_inside(point)) continue;
    if (const auto* csg = dynamic_cast<const CsgSolid*>(children_[i].get())) {
      csg->cutaway_shares(point, out);
    } else if (const auto* leaf = dynamic_cast<const LeafSolid*>(children_[i].get())) {
      if (leaf->leaf().texture.texture) out.emplace_back(&leaf->leaf(), 1);
    }
  }
  if (kind_ == CsgKind::kDifference) return;
  const double share = 1 / static_cast<double>(std::max<std::size_t>(1, out.size() - first));
  for (std::size_t i = first; i < out.size(); ++i) out[i].second = share;
}

}  // namespace lute
