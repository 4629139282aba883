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
      tree_(set_boxes()),
      refusals_(refusals()) {
  for (const auto& child : children_) {
    const auto* leaf = dynamic_cast<const LeafSolid*>(child.get());
    leaves_.push_back(leaf != nullptr && leaf->unclipped() ? leaf : nullptr);
    const auto* combination = dynamic_cast<const CsgSolid*>(child.get());
    dear_ = dear_ || (leaf != nullptr && leaf->shape().prefers_clipped_range()) || (combination != nullptr && combination->dear_);
  }
  if (all_children_needed())
    for (const LeafSolid* leaf : leaves_)
      if (leaf != nullptr && leaf->limits_rays() >= (dear_ ? RayLimits::kForDear : RayLimits::kAlways)) limits_.push_back(leaf);
  opaque = std::ranges::all_of(children_, [](const auto& child) { return child->opaque; });
  hides_children_ =
      !all_children_needed() && std::ranges::any_of(children_, [](const auto& child) { return child->visibility.restricts(); });
}

ChildTree CsgSolid::set_boxes() {
  // A hit lies on one child and inside all others, so no child needs to be tried outside what the others leave. What one child
  // bounds may bound another: a cone by the planes across it.
  constexpr int kRounds = 4;
  boxes_ = std::make_unique<Boxes>();
  Aabb& box = boxes_->hits;
  Aabb& inside_box = boxes_->inside;
  const Aabb clipped = inside_all_within(clips_, Aabb::infinite());
  inside_box = clipped;
  for (int round = 0; round < kRounds; ++round) {
    const Aabb before = inside_box;
    inside_box = narrowed(before);
    if (!all_children_needed() || (before.lo == inside_box.lo && before.hi == inside_box.hi)) break;
  }
  std::vector<Aabb> ray_boxes, all_boxes;
  std::vector<char> boxed;
  for (const auto& child : children_) {
    ray_boxes.push_back(child_hits_within(*child, all_children_needed() ? inside_box : clipped));
    box.join(ray_boxes.back());
    boxed.push_back(!is_cheap(*child) || ray_boxes.back().volume() < 0.5 * child->box().volume());
    all_boxes.push_back(ray_boxes.back());
    // The inside tests of an intersection ask every child.
    if (!all_children_needed()) all_boxes.back().join(child->inside_box());
  }
  box_cuts_ = limit_box(box, bounds_);
  Aabb own = box_cuts_ ? box : Aabb();
  for (const auto& child : children_)
    if (!box_cuts_) own.join(child->box());
  if (const auto limit = closing_box(clips_, own)) {
    box = *limit;
    box_cuts_ = true;
  }
  return ChildTree(std::move(ray_boxes), all_boxes, std::move(boxed));
}

ChildTree CsgSolid::refusals() const {
  std::vector<Aabb> boxes;
  if (all_children_needed())
    for (const auto& child : children_) boxes.push_back(child->outside_bounds());
  const std::size_t count = boxes.size();
  ChildTree tree(boxes, boxes, std::vector<char>(count, false));
  if (remembers_refusals()) tree.mix_order();
  return tree;
}

Aabb CsgSolid::outside_bounds() const {
  if (!clips_.empty() || children_.empty()) return Aabb::infinite();
  Aabb result = all_children_needed() ? Aabb() : Aabb::infinite();
  for (const auto& child : children_) {
    const Aabb part = child->outside_bounds();
    if (all_children_needed())
      result.join(part);
    else
      result = result.intersection(part);
  }
  return result;
}

Aabb CsgSolid::hits_within(const Aabb& region) const {
  return hits_inside(all_children_needed() ? inside_within(region) : region);
}

Aabb CsgSolid::hits_inside(const Aabb& region) const {
  const Aabb limits = region.intersection(boxes_->hits);
  Aabb result;
  for (const auto& child : children_) result.join(child_hits_within(*child, limits));
  return result.intersection(limits);
}

// What is inside of an intersection is inside of its children too, and has been made smaller by theirs: once is enough, or the time
// would be cubic in the depth.
Aabb CsgSolid::child_hits_within(const Solid& child, const Aabb& region) const {
  return all_children_needed() ? child.hits_inside(region) : child.hits_within(region);
}

Aabb CsgSolid::inside_within(const Aabb& region) const {
  const Aabb& own = boxes_->inside;
  const Aabb both = region.intersection(own);
  if (both.lo == own.lo && both.hi == own.hi) return own;  // nothing new
  return narrowed(region);
}

Aabb CsgSolid::narrowed(const Aabb& region) const {
  const Aabb limits = inside_all_within(clips_, region.intersection(boxes_->inside));
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
  if (!hides_children_ || kind.shadow) return true;
  Visibility v = child.visibility;
  v.no_shadow = false;
  if (kind_ == CsgKind::kUnion && kind.primary) v.no_image = false;
  return v.visible_to(kind);
}

bool CsgSolid::in_clips(const dvec3& point) const { return clips_.empty() || inside_all(clips_, point); }

bool CsgSolid::meets_bounds(const Ray& ray) const {
  if (box_cuts_ && !meets_box(ray, {}, boxes_->hits)) return false;
  return bounds_.empty() || meets_all(bounds_, ray);
}

// A hit of an intersection lies inside of all children: leaves in `range` what some of them can tell at once. False if that is nothing.
bool CsgSolid::limit(const Ray& ray, Interval& range) const {
  return std::ranges::all_of(limits_, [&](const LeafSolid* leaf) { return leaf->limit(ray, range); });
}

// Whether child `i` removes a hit of `child`: in an intersection it must be inside of all others, in a merge inside of none. Of two
// equal spheres that cut, or limit, one wall stays: their surface is inside of neither.
bool CsgSolid::refuses(std::size_t i, std::size_t child, const dvec3& point, RayKind kind) const {
  if (i == child) return false;
  if (!all_children_needed()) {
    const Solid& other = *children_[i];
    return other.may_contain(point) && child_visible(other, kind) && inside_child(i, point);
  }
  if (inside_child(i, point)) return false;
  if (leaves_[i] == nullptr || leaves_[child] == nullptr) return true;
  return !leaves_[i]->shares_side(*leaves_[child], point);
}

bool CsgSolid::survives(std::size_t child, const dvec3& point, RayKind kind, RecentRefusals& recent) const {
  if (kind_ == CsgKind::kUnion) return true;
  if (recent.any([&](std::uint32_t i) { return refuses(i, child, point, kind); })) return false;
  bool refused = false;
  (all_children_needed() ? refusals_ : tree_).around(point, [&](std::uint32_t i) {
    refused = refuses(i, child, point, kind);
    if (refused && remembers_refusals()) recent.add(i);
    return refused;
  });
  return !refused;
}

void CsgSolid::hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const {
  if (!limit(ray, range) || !meets_bounds(ray)) return;
  RecentRefusals recent;
  const auto collect = [&](std::size_t i) {
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    children_[i]->hits(ray, range, kind, out);
    // Last in, first out: among equal depths of one child the order turns around at every level, as in the reference.
    std::reverse(out.begin() + first, out.end());
    const auto dead = [&](const Hit& hit) { return !survives(i, hit.point, kind, recent) || !in_clips(hit.point); };
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

// Calls sink(t, point, hit) for the hits of a child, the last found first: of equal depths it wins. `point()` and `hit()` make what
// is needed of the few that count.
template <class Sink>
void CsgSolid::hits_of_child(std::size_t child, const Ray& ray, Interval range, RayKind kind, Sink&& sink) const {
  // Calls within may use the lists' tails, and so move them: hits are read by index.
  if (const LeafSolid* leaf = leaves_[child]; leaf != nullptr) {
    thread_local ShapeHits found;
    const std::size_t first = found.size();
    leaf->shape().hits(ray, range, found);
    for (std::size_t k = found.size(); k > first; --k) {
      const double t = found[k - 1].t;
      sink(t, [&] { return ray.at(t); }, [&] { return Hit{t, ray.at(t), found[k - 1], &leaf->leaf(), nullptr}; });
    }
    found.resize(first);
    return;
  }
  thread_local Hits found;
  const std::size_t first = found.size();
  children_[child]->hits(ray, range, kind, found);
  for (std::size_t k = found.size(); k > first; --k)
    sink(found[k - 1].t, [&] { return found[k - 1].point; }, [&] { return found[k - 1]; });
  found.resize(first);
}

bool CsgSolid::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const {
  if (kind_ == CsgKind::kUnion && clips_.empty()) return nearest_in_union(ray, range, kind, hit);
  // Child by child, so that a near hit spares the inside tests of those behind it.
  if (!limit(ray, range) || !meets_bounds(ray)) return false;
  RecentRefusals recent;
  bool any_found = false;
  std::uint32_t best = 0;
  tree_.along(ray, range, [&](std::uint32_t i, double& far) {
    if (!child_visible(*children_[i], kind)) return false;
    hits_of_child(i, ray, {range.lo, far}, kind, [&](double t, auto&& point, auto&& whole) {
      if (t > far || (any_found && t == far && i < best)) return;  // of equals the last child wins
      const dvec3 at = point();
      if (!survives(i, at, kind, recent) || !in_clips(at)) return;
      hit = whole();
      far = t;
      best = i;
      any_found = true;
    });
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
  if (!limit(ray, range) || !meets_bounds(ray)) return false;
  const bool each_counts = kind_ == CsgKind::kUnion && clips_.empty();
  RecentRefusals recent;
  bool found = false;
  tree_.along(ray, range, [&](std::uint32_t i, double& far) {
    if (!child_visible(*children_[i], kind)) return false;
    if (each_counts) return found = children_[i]->any(ray, range, kind);
    hits_of_child(i, ray, range, kind, [&](double t, auto&& point, auto&&) {
      if (found || t > far) return;
      const dvec3 at = point();
      found = survives(i, at, kind, recent) && in_clips(at);
    });
    return found;
  });
  return found;
}

bool CsgSolid::inside(const dvec3& point) const {
  return may_contain(point) && plain_inside(point) && in_clips(point);
}

bool CsgSolid::plain_inside(const dvec3& point) const {
  if (all_children_needed()) {
    bool refused = false;
    refusals_.around(point, [&](std::uint32_t i) { return refused = !children_[i]->inside(point); });
    return !refused;
  }
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

// plain_inside(), but that the leaf which the point is on counts as inside.
bool CsgSolid::plain_inside_on(const dvec3& point, const Leaf& on) const {
  const auto inside_on = [&](const auto& child) {
    if (child->inside(point)) return true;
    if (const auto* csg = dynamic_cast<const CsgSolid*>(child.get())) return csg->plain_inside_on(point, on) && csg->in_clips(point);
    const auto* leaf = dynamic_cast<const LeafSolid*>(child.get());
    return leaf != nullptr && &leaf->leaf() == &on;
  };
  return all_children_needed() ? std::ranges::all_of(children_, inside_on) : std::ranges::any_of(children_, inside_on);
}

void CsgSolid::cutaway_shares(const dvec3& point, const Leaf& on, CutawayShares& out) const {
  const std::size_t first = out.size();
  const std::size_t asked = kind_ == CsgKind::kDifference ? std::min<std::size_t>(1, children_.size()) : children_.size();
  for (std::size_t i = 0; i < asked; ++i) {
    const bool inside = children_[i]->plain_inside(point);
    if (const auto* csg = dynamic_cast<const CsgSolid*>(children_[i].get())) {
      if (inside || csg->plain_inside_on(point, on)) csg->cutaway_shares(point, on, out);
    } else if (const auto* leaf = dynamic_cast<const LeafSolid*>(children_[i].get())) {
      if (inside && leaf->leaf().texture.texture) out.emplace_back(&leaf->leaf(), 1);
    }
  }
  if (kind_ == CsgKind::kDifference) return;
  const double share = 1 / static_cast<double>(std::max<std::size_t>(1, out.size() - first));
  for (std::size_t i = first; i < out.size(); ++i) out[i].second = share;
}

}  // namespace lute
