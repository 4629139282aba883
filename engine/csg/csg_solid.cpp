#include "engine/csg/csg_solid.hpp"

#include <algorithm>

#include "engine/csg/bounding.hpp"

namespace lute {

CsgSolid::CsgSolid(CsgKind kind, Children children, SharedSolids clips, SharedSolids bounds)
    : kind_(kind),
      marks_(kind != CsgKind::kUnion || !clips.empty()),
      children_(std::move(children)),
      clips_(std::move(clips)),
      bounds_(std::move(bounds)),
      tree_(set_boxes()) {
  opaque = std::ranges::all_of(children_, [](const auto& child) { return child->opaque; });
}

ChildTree CsgSolid::set_boxes() {
  // A hit lies on one child and inside all others, so no child needs to be tried outside what the others leave. What one child
  // bounds may bound another: a cone by the planes across it.
  constexpr int kRounds = 4;
  const Aabb clipped = inside_all_within(clips_, Aabb::infinite());
  inside_box = clipped;
  for (int round = 0; round < kRounds; ++round) {
    const Aabb before = inside_box;
    inside_box = inside_within(before);
    if (!all_children_needed() || (before.lo == inside_box.lo && before.hi == inside_box.hi)) break;
  }
  std::vector<Aabb> ray_boxes, all_boxes;
  box = Aabb();
  for (const auto& child : children_) {
    const Aabb region = all_children_needed() ? inside_box : clipped;
    ray_boxes.push_back(child->hits_within(region));
    box.join(ray_boxes.back());
    all_boxes.push_back(ray_boxes.back());
    // The inside tests of an intersection ask every child.
    if (!all_children_needed()) all_boxes.back().join(child->inside_box);
  }
  box_cuts_ = limit_box(box, bounds_);
  return ChildTree(std::move(ray_boxes), all_boxes);
}

Aabb CsgSolid::hits_within(const Aabb& region) const {
  const Aabb limits = (all_children_needed() ? inside_within(region) : region).intersection(box);
  Aabb result;
  for (const auto& child : children_) result.join(child->hits_within(limits));
  return result.intersection(limits);
}

Aabb CsgSolid::inside_within(const Aabb& region) const {
  const Aabb limits = inside_all_within(clips_, region.intersection(inside_box));
  Aabb result = all_children_needed() ? limits : Aabb();
  for (const auto& child : children_) {
    if (all_children_needed()) {
      result = child->inside_within(result);
    } else {
      result.join(child->inside_within(limits));
    }
  }
  return result;
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
  if (all_children_needed()) {
    for (std::size_t i = 0; i < children_.size(); ++i)
      if (i != child && !children_[i]->inside(point)) return false;
    return true;
  }
  bool hidden = false;
  tree_.around(point, [&](std::uint32_t i) {
    const Solid& other = *children_[i];
    hidden = i != child && other.inside_box.contains(point) && child_visible(other, kind) && other.inside(point);
    return hidden;
  });
  return !hidden;
}

void CsgSolid::hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const {
  if (!meets_bounds(ray)) return;
  const auto collect = [&](std::size_t i) {
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    children_[i]->hits(ray, range, kind, out);
    // Last in, first out: among equal depths of one child the order turns around at every level, as in the reference.
    std::reverse(out.begin() + first, out.end());
    const auto dead = [&](const Hit& hit) { return !survives(i, hit.point, kind) || !in_clips(hit.point); };
    out.erase(std::remove_if(out.begin() + first, out.end(), dead), out.end());
    if (!marks_) return;
    for (auto hit = out.begin() + first; hit != out.end(); ++hit) hit->cutaway = this;
  };
  // In the order of declaration, which decides ties; the tree finds them in another.
  thread_local std::vector<std::uint32_t> found;
  const std::size_t start = found.size();
  tree_.along(ray, range, [&](std::uint32_t i, double&) {
    if (child_visible(*children_[i], kind)) found.push_back(i);
    return false;
  });
  const std::size_t end = found.size();
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(start), found.end());
  for (std::size_t k = start; k < end; ++k) collect(found[k]);  // by index: combinations within use the list's tail
  found.resize(start);
}

bool CsgSolid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (kind_ == CsgKind::kUnion && clips_.empty()) return nearest_in_union(ray, range, kind, hit);
  // Child by child, so that a near hit spares the inside tests of those behind it.
  if (!meets_bounds(ray)) return false;
  thread_local Hits found;
  const std::size_t first = found.size();
  bool any_found = false;
  std::uint32_t best = 0;
  tree_.along(ray, range, [&](std::uint32_t i, double& far) {
    const Solid& child = *children_[i];
    if (!child_visible(child, kind)) return false;
    child.hits(ray, {range.lo, far}, kind, found);
    for (std::size_t k = found.size(); k > first; --k) {
      const Hit candidate = found[k - 1];
      if (candidate.t > far || (any_found && candidate.t == far && i < best)) continue;  // of equals the last child wins
      if (!survives(i, candidate.point, kind) || !in_clips(candidate.point)) continue;
      hit = candidate;
      far = hit.t;
      best = i;
      any_found = true;
    }
    found.resize(first);
    return false;
  });
  if (any_found && marks_) hit.cutaway = this;
  return any_found;
}

bool CsgSolid::nearest_in_union(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (!meets_bounds(ray)) return false;
  bool any_found = false;
  std::uint32_t best = 0;
  tree_.along(ray, range, [&](std::uint32_t i, double& far) {
    Hit candidate;
    if (!child_visible(*children_[i], kind) || !children_[i]->nearest(ray, {range.lo, far}, kind, candidate)) return false;
    if (any_found && candidate.t == far && i < best) return false;
    hit = candidate;
    far = hit.t;
    best = i;
    any_found = true;
    return false;
  });
  return any_found;
}

bool CsgSolid::any(const Ray& ray, Interval range, RayKind kind) const {
  if (kind_ != CsgKind::kUnion || !clips_.empty()) {
    Hit hit;
    return nearest(ray, range, kind, hit);
  }
  if (!meets_bounds(ray)) return false;
  bool found = false;
  tree_.along(ray, range, [&](std::uint32_t i, double&) {
    found = child_visible(*children_[i], kind) && children_[i]->any(ray, range, kind);
    return found;
  });
  return found;
}

bool CsgSolid::inside(const dvec3& point) const {
  return inside_box.contains(point) && plain_inside(point) && in_clips(point);
}

bool CsgSolid::plain_inside(const dvec3& point) const {
  if (children_.empty()) return false;
  if (all_children_needed()) return std::ranges::all_of(children_, [&](const auto& child) { return child->inside(point); });
  bool found = false;
  tree_.around(point, [&](std::uint32_t i) {
    found = children_[i]->inside(point);
    return found;
  });
  return found;
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
