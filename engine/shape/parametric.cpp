#include "engine/shape/parametric.hpp"

#include <algorithm>
#include <cmath>

#include "engine/function/function.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

struct Rectangle {
  dvec2 lo, hi;
};

// Bounds of a function over an edge of length l from its values at the ends.
Interval edge_bounds(double p, double q, double slope_bound) {
  const double extra = std::max(0.0, 0.5 * (slope_bound - std::abs(p - q)));
  return {std::min(p, q) - extra, std::max(p, q) + extra};
}

// A hit keeps (u, v).
class ParametricSurface final : public ScannedShape<ParametricSurface> {
 public:
  ParametricSurface(const Parametric& parametric, const Transform& to_world) : p_(parametric), depth_accuracy_(depth_accuracy(parametric.accuracy, parametric.container, to_world)), to_world_(to_world) {}

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const Ray local = to_world_.inverse_ray(ray);
    Container::Passage passage;
    if (!p_.container.cross(local, passage) || passage.depths.hi < 0) return;
    Interval depths{std::max(0.0, passage.depths.lo) + 4 * depth_accuracy_, passage.depths.hi};
    if (depths.empty()) return;
    double best = std::numeric_limits<double>::infinity();
    dvec2 best_uv(0);
    std::vector<Rectangle> pending{{p_.lo, p_.hi}};
    while (!pending.empty()) {
      const Rectangle r = pending.back();
      pending.pop_back();
      double longest = 0;
      double candidate = 0;
      if (!meets(local, r, depths, best, longest, candidate)) continue;
      const dvec2 side = r.hi - r.lo;
      if (std::max(side.x, side.y) < p_.accuracy || longest < depth_accuracy_) {
        if (depths.lo < candidate && candidate < best) {
          best = candidate;
          best_uv = r.lo;
        }
        continue;
      }
      const int axis = side.y > side.x ? 1 : 0;
      Rectangle low = r;
      Rectangle high = r;
      low.hi[axis] = high.lo[axis] = 0.5 * (r.lo[axis] + r.hi[axis]);
      pending.push_back(high);
      pending.push_back(low);
    }
    if (best < depths.hi) sink(best, 0, std::array<double, 3>{best_uv.x, best_uv.y, 0});
  }

  Aabb bounds() const override { return to_world_.box(p_.container.box()); }
  bool inside(const dvec3&) const override { return false; }
  bool inside_inverted(const dvec3&) const override { return false; }
  bool is_patch() const override { return true; }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    const dvec2 uv(hit.data[0], hit.data[1]);
    const dvec3 here = at(uv);
    const dvec3 n = glm::cross(at(uv + dvec2(p_.accuracy, 0)) - here, at(uv + dvec2(0, p_.accuracy)) - here);
    const double length = glm::length(n);
    return length > 0 ? glm::normalize(to_world_.normal(n / length)) : dvec3(1, 0, 0);
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

  // Bounds of one coordinate over a rectangle; the values at the corners are lowered by the accuracy, as in the reference.
  Interval coordinate_bounds(int axis, const Rectangle& r) const {
    const dvec2 side = r.hi - r.lo;
    const double g = p_.max_gradient;
    const auto corner = [&](double u, double v) { return at(axis, u, v) - p_.accuracy; };
    const Interval low = edge_bounds(corner(r.lo.x, r.lo.y), corner(r.lo.x, r.hi.y), g * side.y);
    const Interval high = edge_bounds(corner(r.hi.x, r.lo.y), corner(r.hi.x, r.hi.y), g * side.y);
    return {edge_bounds(low.lo, high.lo, g * side.x).lo, edge_bounds(low.hi, high.hi, g * side.x).hi};
  }

  // Whether the ray may meet the surface over the rectangle nearer than `best`; the longest of its depth intervals, and where the
  // last of them begins.
  bool meets(const Ray& ray, const Rectangle& r, Interval depths, double best, double& longest, double& candidate) const {
    Interval common{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
      const Interval bounds = coordinate_bounds(axis, r);
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
  Transform to_world_;
};

}  // namespace

std::unique_ptr<Shape> build(const Parametric& parametric, const Transform& to_world, BuildContext&) {
  return std::make_unique<ParametricSurface>(parametric, to_world);
}

}  // namespace lute
