#include "engine/accel/scene_tree.hpp"

namespace lute {

SceneTree::SceneTree(std::span<const Solid* const> solids) {
  std::vector<const Solid*> finite;
  std::vector<Aabb> boxes;
  for (const Solid* solid : solids) {
    if (solid->box.is_finite()) {
      finite.push_back(solid);
      boxes.push_back(solid->box);
    } else if (!solid->box.empty()) {
      unbounded_.push_back(solid);
    }
  }
  bvh_ = Bvh(boxes);
  for (const std::uint32_t i : bvh_.order()) {
    bounded_.push_back(finite[i]);
    scene_index_.push_back(i);
  }
}

bool SceneTree::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters) const {
  bool found = false;
  Hit candidate;
  for (const Solid* solid : unbounded_) {
    if (!solid->visibility.visible_to(kind)) continue;
    ++counters.solid_tests;
    if (!solid->nearest(ray, {range.lo, range.hi}, kind, candidate) || (found && !(candidate.t < hit.t))) continue;
    hit = candidate;
    range.hi = hit.t;
    found = true;
  }
  const bool unbounded_hit = found;
  std::uint32_t winner = 0;
  bool bounded_hit = false;
  bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Solid* solid = bounded_[i];
      if (!solid->visibility.visible_to(kind)) continue;
      ++counters.solid_tests;
      if (!solid->nearest(ray, {range.lo, far}, kind, candidate)) continue;
      if (found && !(candidate.t < hit.t)) {
        // A tie: the first declared wins among bounded solids, an unbounded one before all of them.
        if (candidate.t != hit.t || (unbounded_hit && !bounded_hit) || scene_index_[i] > winner) continue;
      }
      hit = candidate;
      far = hit.t;
      winner = scene_index_[i];
      found = bounded_hit = true;
    }
    return false;
  });
  if (found) ++counters.hits;
  return found;
}

bool SceneTree::nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const {
  RayKind kind;
  kind.primary = false;
  kind.shadow = true;
  return nearest(ray, range, kind, hit, counters);
}

bool SceneTree::any_opaque(const Ray& ray, Interval range, Counters& counters) const {
  RayKind kind;
  kind.primary = false;
  kind.shadow = true;
  const auto blocks = [&](const Solid* solid) {
    if (!solid->opaque || solid->visibility.no_shadow) return false;
    ++counters.solid_tests;
    return solid->any(ray, range, kind);
  };
  for (const Solid* solid : unbounded_)
    if (blocks(solid)) return true;
  bool found = false;
  bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t i = first; i < first + count && !found; ++i) found = blocks(bounded_[i]);
    return found;
  });
  return found;
}

}  // namespace lute
