#include "engine/accel/scene_tree.hpp"

#include <glm/common.hpp>

#include "engine/csg/bounding.hpp"

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
  constexpr std::size_t kFewest = 6;  // below, a tree costs more than it saves
  const auto count = static_cast<std::uint32_t>(solids.size());
  std::vector<Entry> finite;
  std::vector<Aabb> boxes;
  const auto list = [&](const Entry& entry, const Aabb& box) {
    const bool limited = !is_cheap(*entry.solid) && box.half_area() < std::numeric_limits<double>::infinity();
    listed_.push_back({entry, box, limited});
    any_boxed_ = any_boxed_ || limited;
  };
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
      list(entry, box);
    }
  }
  if (finite.size() < kFewest) {
    for (std::size_t i = 0; i < finite.size(); ++i) list(finite[i], boxes[i]);
    return;
  }
  bvh_ = Bvh(boxes);
  for (const std::uint32_t i : bvh_.order()) bounded_.push_back(finite[i]);
}

// Calls visit(entry, far) for what the ray may hit before `far`, which visit may lower, until it returns true.
template <class Visit>
void SceneTree::go_through_list(const Ray& ray, Interval range, Visit&& visit) const {
  if (!any_boxed_) {
    for (const Listed& item : listed_)
      if (visit(item.entry, range.hi)) return;
    return;
  }
  const BoxTest boxes(ray);
  for (const Listed& item : listed_) {
    if (item.boxed && !boxes.meets(range, item.box)) continue;
    if (visit(item.entry, range.hi)) return;
  }
}

// The nearest hit so far.
struct SceneTree::Best {
  Hit& hit;
  const Departure& from;
  bool found = false;
  std::uint32_t rank = 0;
  Hit candidate{};

  // Returns true if the solid has a better hit in [lo, hi].
  bool ask(const Entry& entry, const Ray& ray, Interval range, RayKind kind, Counters& counters) {
    if (!entry.visibility.visible_to(kind)) return false;
    ++counters.solid_tests;
    if (!entry.solid->nearest(ray, range, kind, candidate)) return false;
    if (candidate.t < from.clear && candidate.leaf == from.leaf &&
        !entry.solid->nearest(ray, {from.clear, range.hi}, kind, candidate))
      return false;
    if (found && !(candidate.t < hit.t || (candidate.t == hit.t && entry.rank < rank))) return false;
    hit = candidate;
    rank = entry.rank;
    return found = true;
  }
};

bool SceneTree::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters,
                        const Departure& from) const {
  Best best{hit, from};
  const auto ask = [&](const Entry& entry, double& far) {
    if (best.ask(entry, ray, {range.lo, far}, kind, counters)) far = hit.t;
    return false;
  };
  go_through_list(ray, range, ask);
  if (best.found) range.hi = hit.t;
  if (!bvh_.empty()) {
    bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
      for (std::uint32_t i = first; i < first + count; ++i) ask(bounded_[i], far);
      return false;
    });
  }
  if (best.found) ++counters.hits;
  return best.found;
}

bool SceneTree::nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const {
  return nearest(ray, range, shadow_ray(), hit, counters);
}

bool SceneTree::blocks(const Entry& entry, const Ray& ray, Interval range, LastBlocker& last, bool& filters,
                       Counters& counters) const {
  if (entry.visibility.no_shadow || entry.solid == last.solid || (filters && !entry.blocks)) return false;
  ++counters.solid_tests;
  if (!entry.solid->any(ray, range, shadow_ray())) return false;
  if (!entry.blocks) {
    filters = true;
    return false;
  }
  last = {entry.solid, 0};
  return true;
}

Obstruction SceneTree::obstruction(const Ray& ray, Interval range, LastBlocker& last, Counters& counters) const {
  constexpr int kForgiven = 8;
  if (last.solid != nullptr) {
    ++counters.solid_tests;
    if (last.solid->any(ray, range, shadow_ray())) {
      last.misses = 0;
      return Obstruction::kOpaque;
    }
  }
  bool opaque = false, filters = false;
  go_through_list(ray, range, [&](const Entry& entry, double&) {
    return opaque = blocks(entry, ray, range, last, filters, counters);
  });
  if (!opaque && !bvh_.empty()) {
    bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double&) {
      for (std::uint32_t i = first; i < first + count && !opaque; ++i)
        opaque = blocks(bounded_[i], ray, range, last, filters, counters);
      return opaque;
    });
  }
  if (opaque) return Obstruction::kOpaque;
  if (last.solid != nullptr && ++last.misses > kForgiven) last = {};
  return filters ? Obstruction::kFilter : Obstruction::kNone;
}

}  // namespace lute
