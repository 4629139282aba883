#include "engine/shape/slope_tree.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/function/enclosure.hpp"

namespace lute {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kAnything{-kInfinity, kInfinity};
constexpr int kDeepest = 5;  // 32 nodes along each axis
// A node's bounds may fail so often before it is divided: about as many evaluations of the function as its children's bounds cost.
constexpr int kPatience = 48;

// Nodes are many: they keep their bounds as floats.
struct Bounds {
  float lo = -std::numeric_limits<float>::infinity(), hi = std::numeric_limits<float>::infinity();

  Bounds() = default;
  Bounds(double low, double high) : lo(static_cast<float>(low)), hi(static_cast<float>(high)) {
    if (lo > low) lo = std::nextafter(lo, -std::numeric_limits<float>::infinity());
    if (hi < high) hi = std::nextafter(hi, std::numeric_limits<float>::infinity());
  }
};

}  // namespace

struct SlopeTree::Node {
  Bounds value, slope[3];
  bool known = false;  // false: the function has no enclosure
  mutable std::atomic<int> failures{0};
  mutable std::atomic<Octants*> octants{nullptr};

  ~Node();
};

struct SlopeTree::Octants {
  std::array<Node, 8> nodes;
};

SlopeTree::Node::~Node() { delete octants.load(); }

SlopeTree::SlopeTree(std::shared_ptr<const Function> function, const Aabb& box)
    : function_(std::move(function)), center_(box.center()), half_(0.5 * (box.hi - box.lo)) {}
SlopeTree::~SlopeTree() = default;

void SlopeTree::bound(Node& node, const dvec3& center, const dvec3& half) const {
  // Points of a ray lie a rounding error beside the node that they are counted to.
  const dvec3 reach = half + dvec3(1e-12 * (glm::length(half_) + glm::length(center_)));
  for (int along = 0; along < 3; ++along) {
    Enclosure arguments[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double slope = axis == along ? 1 : 0;
      arguments[axis] = {center[axis] - reach[axis], center[axis] + reach[axis], slope, slope};
    }
    Enclosure result;
    if (!function_->enclose(arguments, &result)) return;
    node.value = {result.lo, result.hi};
    node.slope[along] = {result.slope_lo, result.slope_hi};
  }
  node.known = true;
}

const SlopeTree::Node& SlopeTree::root() const {
  std::call_once(made_, [&] {
    root_ = std::make_unique<Node>();
    bound(*root_, center_, half_);
    double sum = 0;
    for (const Bounds& s : root_->slope) {
      const double most = std::max(std::abs(s.lo), std::abs(s.hi));
      sum += most * most;
    }
    steepest_ = std::sqrt(sum) * (1 + 1e-12);
  });
  return *root_;
}

// Whoever is first puts the octants in their place; all would make the same.
const SlopeTree::Octants& SlopeTree::divide(const Node& node, const dvec3& center, const dvec3& quarter) const {
  auto made = std::make_unique<Octants>();
  for (int octant = 0; octant < 8; ++octant) {
    dvec3 part = center;
    for (int axis = 0; axis < 3; ++axis) part[axis] += octant >> axis & 1 ? quarter[axis] : -quarter[axis];
    bound(made->nodes[static_cast<std::size_t>(octant)], part, quarter);
  }
  Octants* expected = nullptr;
  if (node.octants.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) return *made.release();
  return *expected;
}

bool SlopeTree::knows_function() const { return root().known; }

double SlopeTree::steepest() const {
  root();
  return steepest_;
}

// From node to node along one ray. What lies in the plane between two nodes may be counted to either.
struct SlopeTree::Walk {
  const SlopeTree& tree;
  const Ray& ray;
  dvec3 inverse;
  std::vector<Piece>& out;

  void visit(const Node& node, const dvec3& center, const dvec3& half, int depth, Interval depths) {
    const Octants* octants = node.octants.load(std::memory_order_acquire);
    if (octants == nullptr && (depth == kDeepest || node.failures.load(std::memory_order_relaxed) < kPatience)) {
      out.push_back({depths.hi, {node.value.lo, node.value.hi}, &node});
      return;
    }
    // A ray meets its octants in ascending order of the depths at which it crosses the planes between them; one that runs in such a plane
    // has no number there.
    double cuts[3];
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double t = (center[axis] - ray.origin[axis]) * inverse[axis];
      if (!(depths.lo < t && t < depths.hi)) continue;
      int place = count++;
      for (; place > 0 && cuts[place - 1] > t; --place) cuts[place] = cuts[place - 1];
      cuts[place] = t;
    }
    const dvec3 quarter = 0.5 * half;
    if (octants == nullptr) octants = &tree.divide(node, center, quarter);
    double begin = depths.lo;
    for (int i = 0; i <= count; ++i) {
      const double end = i < count ? cuts[i] : depths.hi;
      const dvec3 middle = ray.at(0.5 * (begin + end));
      std::size_t octant = 0;
      dvec3 part = center;
      for (int axis = 0; axis < 3; ++axis) {
        const bool upper = middle[axis] >= center[axis];
        octant |= static_cast<std::size_t>(upper) << axis;
        part[axis] += upper ? quarter[axis] : -quarter[axis];
      }
      visit(octants->nodes[octant], part, quarter, depth + 1, {begin, end});
      begin = end;
    }
  }
};

void SlopeTree::find_slope(const Ray& ray, Piece& piece) {
  double lo = 0, hi = 0, size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) continue;  // times infinity
    const Bounds& s = piece.node->slope[axis];
    lo += d * (d < 0 ? s.hi : s.lo);
    hi += d * (d < 0 ? s.lo : s.hi);
    size += std::abs(d) * std::max(std::abs(s.lo), std::abs(s.hi));
  }
  piece.slope = size < kInfinity ? Interval{lo - 1e-14 * size, hi + 1e-14 * size} : kAnything;
  piece.slope_known = true;
}

void SlopeTree::along(const Ray& ray, Interval depths, std::vector<Piece>& out) const {
  out.clear();
  Walk{*this, ray, 1.0 / ray.direction, out}.visit(root(), center_, half_, 0, depths);
}

void SlopeTree::too_wide(const Piece& piece) {
  auto& failures = piece.node->failures;
  if (failures.load(std::memory_order_relaxed) < kPatience) failures.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace lute
