#include "engine/accel/scene_tree.hpp"

#include <glm/common.hpp>

#include "engine/csg/bounding.hpp"
#include "engine/csg/leaf_solid.hpp"

namespace lute {

namespace {

constexpr double kLargestFiniteVolume = 2e10;
constexpr double kFarthestBound = 1e30;  // what single-precision boxes can hold with room for arithmetic

bool is_infinite(const Aabb& box) { return !(box.volume() <= kLargestFiniteVolume); }

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

AskedSolid::AskedSolid(const Solid& asked) : solid(&asked) {
  const auto* own = dynamic_cast<const LeafSolid*>(&asked);
  if (own == nullptr || !own->unclipped()) return;
  shape = &own->shape();
  leaf = &own->leaf();
}

bool AskedSolid::blocks(const Ray& ray, Interval range) const {
  return shape != nullptr ? shape->any(ray, range) : solid->any(ray, range, shadow_ray());
}

SceneTree::SceneTree(std::span<const Solid* const> solids) {
  constexpr std::size_t kFewest = 6;  // below, a tree costs more than it saves
  const auto count = static_cast<std::uint32_t>(solids.size());
  std::vector<std::uint32_t> finite;
  const auto entry = [&](std::uint32_t i, bool infinite) {
    const Visibility visibility = solids[i]->visibility;
    return Entry{solids[i], infinite ? i : count + i, visibility, solids[i]->opaque && !visibility.no_shadow};
  };
  const auto list = [&](const Entry& listed, const Aabb& box) {
    const bool limited = !is_cheap(*listed.solid) && box.half_area() < std::numeric_limits<double>::infinity();
    listed_.push_back({listed, box, limited});
    any_boxed_ = any_boxed_ || limited;
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const Aabb box = solids[i]->box();
    if (box.empty()) continue;
    if (fits_tree(box)) finite.push_back(i);
    else list(entry(i, is_infinite(box)), box);
  }
  if (finite.size() < kFewest) {
    for (const std::uint32_t i : finite) list(entry(i, is_infinite(solids[i]->box())), solids[i]->box());
    return;
  }
  bvh_ = Bvh(finite.size(), [&](std::size_t i) { return solids[finite[i]]->box(); });
  const std::vector<std::uint32_t> order = bvh_.take_order();
  bounded_.reserve(order.size());
  for (const std::uint32_t i : order) bounded_.push_back(entry(finite[i], is_infinite(solids[finite[i]]->box())));
}

// Calls visit(entry, far) for what the ray may hit before `far`, which visit may lower, until it returns true.
template <class Visit>
void SceneTree::go_through_list(const Ray& ray, Interval& range, Visit&& visit) const {
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
class SceneTree::Best {
 public:
  Best(const Ray& ray, double near, RayKind kind, const Departure& from, Hit& hit)
      : ray_(ray), near_(near), kind_(kind), from_(from), hit_(hit) {}

  // Lowers `far` to the depth of the entry's hit, if that is better.
  void ask(const Entry& entry, double& far) {
    if (entry.restricted && !entry.visibility.visible_to(kind_)) return;
    ++asked_;
    if (entry.asked.shape != nullptr)
      ask_shape(entry, far);
    else
      ask_solid(entry, far);
  }

  bool finish(Counters& counters) const {
    counters.solid_tests += asked_;
    if (!found_) return false;
    ++counters.hits;
    if (of_shape_) hit_.point = ray_.at(hit_.t);
    return true;
  }

 private:
  bool at_start(double t, const Leaf* leaf) const { return t < from_.clear && leaf == from_.leaf; }
  bool better(double t, std::uint32_t rank) const { return !found_ || t < hit_.t || (t == hit_.t && rank < rank_); }
  void take(const Entry& entry, double& far) {
    rank_ = entry.rank;
    found_ = true;
    far = hit_.t;
  }

  void ask_shape(const Entry& entry, double& far) {
    const Shape& shape = *entry.asked.shape;
    ShapeHit candidate;
    if (!shape.nearest(ray_, {near_, far}, candidate)) return;
    if (at_start(candidate.t, entry.asked.leaf) && !shape.nearest(ray_, {from_.clear, far}, candidate)) return;
    if (!better(candidate.t, entry.rank)) return;
    hit_.t = candidate.t;
    hit_.shape_hit = candidate;
    hit_.leaf = entry.asked.leaf;
    hit_.cutaway = nullptr;
    of_shape_ = true;
    take(entry, far);
  }

  void ask_solid(const Entry& entry, double& far) {
    const Solid& solid = *entry.asked.solid;
    Hit candidate;
    if (!solid.nearest(ray_, {near_, far}, kind_, candidate)) return;
    if (at_start(candidate.t, candidate.leaf) && !solid.nearest(ray_, {from_.clear, far}, kind_, candidate)) return;
    if (!better(candidate.t, entry.rank)) return;
    hit_ = candidate;
    of_shape_ = false;
    take(entry, far);
  }

  const Ray& ray_;
  double near_;
  RayKind kind_;
  const Departure& from_;
  Hit& hit_;
  std::uint64_t asked_ = 0;
  bool found_ = false, of_shape_ = false;
  std::uint32_t rank_ = 0;
};

bool SceneTree::nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit, Counters& counters,
                        const Departure& from) const {
  Best best(ray, range.lo, kind, from, hit);
  go_through_list(ray, range, [&](const Entry& entry, double& far) {
    best.ask(entry, far);
    return false;
  });
  if (!bvh_.empty()) {
    bvh_.traverse(ray, range, counters.box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
      for (std::uint32_t i = first; i < first + count; ++i) best.ask(bounded_[i], far);
      return false;
    });
  }
  return best.finish(counters);
}

bool SceneTree::nearest_shadow(const Ray& ray, Interval range, Hit& hit, Counters& counters) const {
  return nearest(ray, range, shadow_ray(), hit, counters);
}

bool SceneTree::blocks(const Entry& entry, const Ray& ray, Interval range, LastBlocker& last, bool& filters,
                       Counters& counters) const {
  if (entry.visibility.no_shadow || entry.asked.solid == last.asked.solid || (filters && !entry.blocks)) return false;
  ++counters.solid_tests;
  if (!entry.asked.blocks(ray, range)) return false;
  if (!entry.blocks) {
    filters = true;
    return false;
  }
  last = {entry.asked, 0};
  return true;
}

Obstruction SceneTree::obstruction(const Ray& ray, Interval range, LastBlocker& last, Counters& counters) const {
  constexpr int kForgiven = 8;
  if (last.asked.solid != nullptr) {
    ++counters.solid_tests;
    if (last.asked.blocks(ray, range)) {
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
  if (last.asked.solid != nullptr && ++last.misses > kForgiven) last = {};
  return filters ? Obstruction::kFilter : Obstruction::kNone;
}

}  // namespace lute
