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

bool is_unclipped(const Solid& solid) {
  const auto* leaf = dynamic_cast<const LeafSolid*>(&solid);
  return leaf != nullptr && leaf->unclipped();
}

const LeafSolid& as_leaf(const Solid& solid) { return static_cast<const LeafSolid&>(solid); }

// For an entry of the tree, and for a blocker.
bool stops_shadow_ray(const auto& asked, const Ray& ray, Interval range) {
  return asked.unclipped ? as_leaf(*asked.solid).shape().any(ray, range) : asked.solid->any(ray, range, shadow_ray());
}

}  // namespace

SceneTree::SceneTree(std::size_t size, const std::function<const Solid*(std::size_t)>& solid_at) {
  constexpr std::size_t kFewest = 6;  // below, a tree costs more than it saves
  const auto count = static_cast<std::uint32_t>(size);
  std::size_t finite = 0;
  const auto entry = [&](std::uint32_t i, bool infinite) {
    const Solid* solid = solid_at(i);
    const Visibility visibility = solid->visibility;
    return Entry{.solid = solid,
                 .rank = infinite ? i : count + i,
                 .visibility = visibility,
                 .unclipped = is_unclipped(*solid),
                 .restricted = visibility.restricts(),
                 .blocks = solid->opaque && !visibility.no_shadow};
  };
  const auto list = [&](const Entry& listed, const Aabb& box) {
    const bool limited = !is_cheap(*listed.solid) && box.half_area() < std::numeric_limits<double>::infinity();
    listed_.push_back({listed, box, limited});
    any_boxed_ = any_boxed_ || limited;
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const Aabb box = solid_at(i)->box();
    if (box.empty()) continue;
    if (fits_tree(box)) ++finite;
    else list(entry(i, is_infinite(box)), box);
  }
  const auto finite_box = [&](std::size_t i) {
    const Aabb box = solid_at(i)->box();
    return fits_tree(box) ? box : Aabb();
  };
  if (finite < kFewest) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (const Aabb box = finite_box(i); !box.empty()) list(entry(i, is_infinite(box)), box);
    return;
  }
  bvh_ = Bvh(count, finite_box);
  const std::vector<std::uint32_t> order = bvh_.take_order();
  bounded_.reserve(order.size());
  for (const std::uint32_t i : order) bounded_.push_back(entry(i, is_infinite(solid_at(i)->box())));
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
    if (entry.unclipped)
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
    const LeafSolid& solid = as_leaf(*entry.solid);
    const Shape& shape = solid.shape();
    ShapeHit candidate;
    if (!shape.nearest(ray_, {near_, far}, candidate)) return;
    if (at_start(candidate.t, &solid.leaf()) && !shape.nearest(ray_, {from_.clear, far}, candidate)) return;
    if (!better(candidate.t, entry.rank)) return;
    hit_.t = candidate.t;
    hit_.shape_hit = candidate;
    hit_.leaf = &solid.leaf();
    hit_.cutaway = nullptr;
    of_shape_ = true;
    take(entry, far);
  }

  void ask_solid(const Entry& entry, double& far) {
    const Solid& solid = *entry.solid;
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
  if (entry.visibility.no_shadow || entry.solid == last.solid || (filters && !entry.blocks)) return false;
  ++counters.solid_tests;
  if (!stops_shadow_ray(entry, ray, range)) return false;
  if (!entry.blocks) {
    filters = true;
    return false;
  }
  last = {entry.solid, entry.unclipped, 0};
  return true;
}

Obstruction SceneTree::obstruction(const Ray& ray, Interval range, LastBlocker& last, Counters& counters) const {
  constexpr int kForgiven = 8;
  if (last.solid != nullptr) {
    ++counters.solid_tests;
    if (stops_shadow_ray(last, ray, range)) {
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
