#include "engine/accel/scene_tree.hpp"

#include <glm/common.hpp>

namespace lute {

namespace {

constexpr double kLargestFiniteVolume = 2e10;
constexpr double kFarthestBound = 1e30;  // what single-precision boxes can hold with room for arithmetic

bool fits_tree(const Aabb& box) {
  return glm::all(glm::lessThan(glm::abs(box.lo), dvec3(kFarthestBound))) &&
         glm::all(glm::lessThan(glm::abs(box.hi), dvec3(kFarthestBound)));
}

RayKind shadow_ray() {
  RayKind kind;
  kind.primary = false;
  kind.shadow = true;
  return kind;
}

}  // namespace

SceneTree::SceneTree(std::span<const Solid* const> solids) {
  const auto count = static_cast<std::uint32_t>(solids.size());
  std::vector<Entry> finite;
  std::vector<Aabb> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Aabb& box = solids[i]->box;
    if (box.empty()) continue;
    const bool infinite = !(box.volume() <= kLargestFiniteVolume);
    const Visibility visibility = solids[i]->visibility;
    const Entry entry{solids[i], infinite ? i : count + i, visibility, solids[i]->opaque && !visibility.no_shadow};
    if (fits_tree(box)) {
      finite.push_back(entry);
      boxes.push_back(box);
    } else {
      unbounded_.push_back(entry);
    }
  }
  bvh_ = Bvh(boxes);
  for (const std::uint32_t i : bvh_.order()) bounded_.push_back(finite[i]);
}

// The nearest hit so far.
struct SceneTree::Best {
  Hit& hit;
  bool found = false;
  std::uint32_t rank = 0;
  Hit candidate{};

  // Returns true if the solid has a better hit in [lo, hi].
  bool ask(const Entry& entry, const Ray& ray, Interval range, RayKind kind, Counters& counters) {
    if (!entry.visibility.visible_to(kind)) return false;
    ++counters.solid_tests;
    if (!entry.solid->nearest(ray, range, kind, candidate)) return false;
    if (found && !(candidate.t < hit.t || (candidate.t == hit.t && entry.rank < rank))) return false;
    hit = candidate;
    rank = entry.rank;
    return found = true;
  }
};

bool SceneTree::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters) const {
  Best best{hit};
  for (const Entry& entry : unbounded_)
    if (best.ask(entry, ray, range, kind, counters)) range.hi = hit.t;
  bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
    for (std::uint32_t i = first; i < first + count; ++i)
      if (best.ask(bounded_[i], ray, {range.lo, far}, kind, counters)) far = hit.t;
    return false;
  });
  if (best.found) ++counters.hits;
  return best.found;
}

bool SceneTree::nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const {
  return nearest(ray, range, shadow_ray(), hit, counters);
}

bool SceneTree::any_opaque(const Ray& ray, Interval range, Counters& counters) const {
  const auto blocks = [&](const Entry& entry) {
    if (!entry.blocks) return false;
    ++counters.solid_tests;
    return entry.solid->any(ray, range, shadow_ray());
  };
  for (const Entry& entry : unbounded_)
    if (blocks(entry)) return true;
  bool found = false;
  bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
    for (std::uint32_t i = first; i < first + count && !found; ++i) found = blocks(bounded_[i]);
    return found;
  });
  return found;
}

}  // namespace lute
