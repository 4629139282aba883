#include "engine/shape/parametric.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "engine/function/function.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

struct Rectangle {
  dvec2 lo, hi;

  int longer_side() const { return hi.y - lo.y > hi.x - lo.x ? 1 : 0; }
  Rectangle half(int axis, bool upper) const {
    Rectangle part = *this;
    (upper ? part.lo : part.hi)[axis] = 0.5 * (lo[axis] + hi[axis]);
    return part;
  }
};

// Bounds of a function over an edge of length l from its values at the ends.
Interval edge_bounds(double p, double q, double slope_bound) {
  const double extra = std::max(0.0, 0.5 * (slope_bound - std::abs(p - q)));
  return {std::min(p, q) - extra, std::max(p, q) + extra};
}

// Values of x, y, z at the corners (lo, lo), (lo, hi), (hi, lo), (hi, hi) of a rectangle, lowered by the accuracy, as in the reference.
using Corners = std::array<dvec3, 4>;

// The bounds of x, y and z over a rectangle.
using Box = std::array<Interval, 3>;

Box box_of(const Rectangle& r, const Corners& corners, double gradient) {
  const dvec2 side = gradient * (r.hi - r.lo);
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval low = edge_bounds(corners[0][axis], corners[1][axis], side.y);
    const Interval high = edge_bounds(corners[2][axis], corners[3][axis], side.y);
    box[static_cast<std::size_t>(axis)] = {edge_bounds(low.lo, high.lo, side.x).lo, edge_bounds(low.hi, high.hi, side.x).hi};
  }
  return box;
}

// The boxes of the first divisions, the same for every ray and every copy: number 1 is the whole, the halves of n are 2 n and 2 n + 1. A box
// is computed by the first ray that asks.
class BoxTree {
 public:
  static constexpr std::uint32_t kNodes = 1u << 15;

  BoxTree() : nodes_(kNodes) {}

  template <class Compute>
  Box box(std::uint32_t node, Compute&& compute) const {
    Node& n = nodes_[node];
    if (n.state.load(std::memory_order_acquire) == kReady) return n.box;
    const Box box = compute();
    int expected = kEmpty;
    if (n.state.compare_exchange_strong(expected, kClaimed, std::memory_order_relaxed)) {
      n.box = box;
      n.state.store(kReady, std::memory_order_release);
    }
    return box;
  }

 private:
  enum State : int { kEmpty, kClaimed, kReady };
  struct Node {
    Box box;
    std::atomic<int> state{kEmpty};
  };
  mutable std::vector<Node> nodes_;
};

// A hit keeps (u, v).
class ParametricSurface final : public ScannedShape<ParametricSurface> {
 public:
  ParametricSurface(const Parametric& parametric, const SharedTransform& to_world, std::shared_ptr<const BoxTree> tree)
      : p_(parametric), depth_accuracy_(depth_accuracy(parametric.accuracy, parametric.container, to_world)), to_world_(to_world),
        tree_(std::move(tree)) {}

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    const Ray local = to_world_->inverse_ray(ray);
    Container::Passage passage;
    if (!p_.container.cross(local, passage) || passage.depths.hi < 0) return;
    const Interval depths{std::max(0.0, passage.depths.lo) + 4 * depth_accuracy_, passage.depths.hi};
    if (depths.empty() || depths.lo > range.hi) return;
    double best = std::numeric_limits<double>::infinity();
    dvec2 best_uv(0);
    thread_local std::vector<Pending> pending;
    pending.clear();
    pending.push_back({{p_.lo, p_.hi}, 1, {}});
    while (!pending.empty()) {
      const Pending here = pending.back();
      pending.pop_back();
      double longest = 0;
      double candidate = 0;
      if (!meets(local, box(here), depths, best, longest, candidate)) continue;
      const Rectangle& r = here.rectangle;
      const dvec2 side = r.hi - r.lo;
      if (std::max(side.x, side.y) < p_.accuracy || longest < depth_accuracy_) {
        if (depths.lo < candidate && candidate < best) {
          best = candidate;
          best_uv = r.lo;
        }
        continue;
      }
      divide(here, pending);
    }
    if (best < depths.hi) sink(best, 0, std::array<double, 3>{best_uv.x, best_uv.y, 0});
  }

  Aabb bounds() const override { return to_world_->box(p_.container.box()); }
  bool inside(const dvec3&) const override { return false; }
  bool inside_inverted(const dvec3&) const override { return false; }
  bool is_patch() const override { return true; }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    const dvec2 uv(hit.data[0], hit.data[1]);
    const dvec3 here = at(uv);
    const dvec3 n = glm::cross(at(uv + dvec2(p_.accuracy, 0)) - here, at(uv + dvec2(0, p_.accuracy)) - here);
    const double length = glm::length(n);
    return length > 0 ? glm::normalize(to_world_->normal(n / length)) : dvec3(1, 0, 0);
  }
  dvec2 uv(const ShapeHit& hit, const dvec3&) const override { return {hit.data[0], hit.data[1]}; }

 private:
  double at(int axis, double u, double v) const {
    const double arguments[3] = {u, v, 0};  // a function written without parameters has three
    double result = 0;
    p_.functions[static_cast<std::size_t>(axis)]->evaluate(arguments, &result);
    return result;
  }
  dvec3 at(const dvec2& uv) const { return {at(0, uv.x, uv.y), at(1, uv.x, uv.y), at(2, uv.x, uv.y)}; }

  // A rectangle to look into; `node` is its number in the tree, or 0 beyond: then the values at its corners are known.
  struct Pending {
    Rectangle rectangle;
    std::uint32_t node;
    Corners corners;
  };

  dvec3 corner(double u, double v) const { return at({u, v}) - p_.accuracy; }
  Corners corners_of(const Rectangle& r) const {
    return {corner(r.lo.x, r.lo.y), corner(r.lo.x, r.hi.y), corner(r.hi.x, r.lo.y), corner(r.hi.x, r.hi.y)};
  }

  Box box(const Pending& p) const {
    if (p.node == 0) return box_of(p.rectangle, p.corners, p_.max_gradient);
    return tree_->box(p.node, [&] { return box_of(p.rectangle, corners_of(p.rectangle), p_.max_gradient); });
  }

  // Halves the longer side; the lower half is looked into first.
  void divide(const Pending& whole, std::vector<Pending>& pending) const {
    const int axis = whole.rectangle.longer_side();
    Pending low{whole.rectangle.half(axis, false), 0, {}}, high{whole.rectangle.half(axis, true), 0, {}};
    if (whole.node != 0 && 2 * whole.node + 1 < BoxTree::kNodes) {
      low.node = 2 * whole.node;
      high.node = 2 * whole.node + 1;
    } else {
      low.corners = high.corners = whole.node == 0 ? whole.corners : corners_of(whole.rectangle);
      const double middle = low.rectangle.hi[axis];
      const Rectangle& r = whole.rectangle;
      const dvec3 a = axis == 0 ? corner(middle, r.lo.y) : corner(r.lo.x, middle), b = axis == 0 ? corner(middle, r.hi.y) : corner(r.hi.x, middle);
      if (axis == 0) {
        low.corners[2] = high.corners[0] = a;
        low.corners[3] = high.corners[1] = b;
      } else {
        low.corners[1] = high.corners[0] = a;
        low.corners[3] = high.corners[2] = b;
      }
    }
    pending.push_back(high);
    pending.push_back(low);
  }

  // Whether the ray may meet the surface over the rectangle nearer than `best`; the longest of its depth intervals, and where the
  // last of them begins.
  static bool meets(const Ray& ray, const Box& box, Interval depths, double best, double& longest, double& candidate) {
    Interval common{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
      const Interval bounds = box[static_cast<std::size_t>(axis)];
      const double p = ray.origin[axis];
      const double d = ray.direction[axis];
      if (std::abs(d) < kEpsilon) {
        if (!bounds.contains(p)) return false;
        continue;
      }
      const double t0 = (bounds.lo - p) / d;
      const double t1 = (bounds.hi - p) / d;
      const Interval t{std::min(t0, t1), std::max(t0, t1)};
      if (t.lo > depths.hi || t.hi < depths.lo || t.lo > best || t.lo > common.hi || t.hi < common.lo) return false;
      common = {std::max(common.lo, t.lo), std::min(common.hi, t.hi)};
      longest = std::max(longest, t.hi - t.lo);
      candidate = t.lo;
    }
    return true;
  }

  Parametric p_;
  double depth_accuracy_;
  SharedTransform to_world_;
  std::shared_ptr<const BoxTree> tree_;
};

// Copies of a surface share its boxes: those with the same functions, rectangle and bounds. All of one first function are kept together.
class BoxTrees {
 public:
  std::shared_ptr<const BoxTree> of(const Parametric& p) const {
    for (const Entry& e : entries_)
      if (e.lo == p.lo && e.hi == p.hi && e.accuracy == p.accuracy && e.max_gradient == p.max_gradient &&
          e.y == p.functions[1].get() && e.z == p.functions[2].get())
        return e.tree;
    entries_.push_back({p.lo, p.hi, p.accuracy, p.max_gradient, p.functions[1].get(), p.functions[2].get(), std::make_shared<const BoxTree>()});
    return entries_.back().tree;
  }

 private:
  struct Entry {
    dvec2 lo, hi;
    double accuracy, max_gradient;
    const Function *y, *z;
    std::shared_ptr<const BoxTree> tree;
  };
  mutable std::vector<Entry> entries_;  // grows while the scene is built, by one thread
};

}  // namespace

std::unique_ptr<Shape> build(const Parametric& parametric, const SharedTransform& to_world, BuildContext& context) {
  // The function's own address is that of what isosurfaces share.
  const void* key = reinterpret_cast<const char*>(parametric.functions[0].get()) + 1;
  auto trees = std::static_pointer_cast<const BoxTrees>(context.find_shared(key));
  if (!trees) context.store_shared(key, trees = std::make_shared<const BoxTrees>());
  return std::make_unique<ParametricSurface>(parametric, to_world, trees->of(parametric));
}

}  // namespace lute
