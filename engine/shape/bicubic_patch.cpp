#include "engine/shape/bicubic_patch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/accel/bvh.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/watertight_triangle.hpp"

namespace lute {

namespace {

using Points = std::array<std::array<dvec3, 4>, 4>;

struct Corner {
  double u, v;
  dvec3 point;
};
using Facet = std::array<Corner, 3>;

// De Casteljau at one half: the control points of both halves of a cubic.
void halve(const std::array<dvec3, 4>& p, std::array<dvec3, 4>& low, std::array<dvec3, 4>& high) {
  const dvec3 a = 0.5 * (p[0] + p[1]), b = 0.5 * (p[1] + p[2]), c = 0.5 * (p[2] + p[3]);
  const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c);
  const dvec3 middle = 0.5 * (ab + bc);
  low = {p[0], a, ab, middle};
  high = {middle, bc, c, p[3]};
}

Points transposed(const Points& p) {
  Points t;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) t[j][i] = p[i][j];
  return t;
}

void halve_v(const Points& p, Points& low, Points& high) {
  for (std::size_t i = 0; i < 4; ++i) halve(p[i], low[i], high[i]);
}

void halve_u(const Points& p, Points& low, Points& high) {
  halve_v(transposed(p), low, high);
  low = transposed(low);
  high = transposed(high);
}

// Chapter 21 §5.2: all control points nearer than `flatness` to the plane through three corners.
bool is_flat(const Points& p, double flatness) {
  const dvec3 a = p[0][0];
  dvec3 b = p[0][3];
  const dvec3 c = p[3][0];
  if (glm::length(a - b) < kEpsilon) b = p[3][3];
  if (glm::length(a - b) < kEpsilon || glm::length(b - c) < kEpsilon) return false;
  const dvec3 e = b - a;
  const dvec3 f = c - a;
  const dvec3 n = glm::cross(e, f);
  if (glm::dot(n, n) <= kEpsilon * glm::dot(e, e) * glm::dot(f, f)) return false;
  const dvec3 unit = glm::normalize(n);
  double most = 0;
  for (const auto& row : p)
    for (const dvec3& point : row) most = std::max(most, std::abs(glm::dot(point - a, unit)));
  return most < flatness;
}

class Tessellation {
 public:
  Tessellation(const BicubicPatch& patch, const Points& points) : patch_(patch) { divide(points, 0, 1, 0, 1, 0); }
  std::vector<Facet> facets;

 private:
  void divide(const Points& p, double u0, double u1, double v0, double v1, int depth) {
    const bool u_done = depth >= patch_.u_steps;
    const bool v_done = depth >= patch_.v_steps;
    if ((u_done && v_done) || is_flat(p, patch_.flatness)) return add_leaf(p, u0, u1, v0, v1);
    const double um = 0.5 * (u0 + u1);
    const double vm = 0.5 * (v0 + v1);
    Points low, high;
    if (u_done) {
      halve_v(p, low, high);
      divide(low, u0, u1, v0, vm, depth + 1);
      divide(high, u0, u1, vm, v1, depth + 1);
      return;
    }
    halve_u(p, low, high);
    if (v_done) {
      divide(low, u0, um, v0, v1, depth + 1);
      divide(high, um, u1, v0, v1, depth + 1);
      return;
    }
    Points left, right;
    halve_v(low, left, right);
    divide(left, u0, um, v0, vm, depth + 1);
    divide(right, u0, um, vm, v1, depth + 1);
    halve_v(high, left, right);
    divide(left, um, u1, v0, vm, depth + 1);
    divide(right, um, u1, vm, v1, depth + 1);
  }

  void add_leaf(const Points& p, double u0, double u1, double v0, double v1) {
    const Corner a{u0, v0, p[0][0]}, b{u0, v1, p[0][3]}, c{u1, v1, p[3][3]}, d{u1, v0, p[3][0]};
    add({a, b, c});
    add({a, c, d});
  }

  void add(const Facet& f) {
    const dvec3 e = f[1].point - f[0].point;
    const dvec3 g = f[2].point - f[0].point;
    const dvec3 n = glm::cross(e, g);
    if (glm::dot(n, n) > kEpsilon * glm::dot(e, e) * glm::dot(g, g)) facets.push_back(f);
  }

  const BicubicPatch& patch_;
};

// A hit keeps the facet and the weights of its corners.
class FacetedPatch final : public ScannedShape<FacetedPatch> {
 public:
  FacetedPatch(const BicubicPatch& patch, const Points& points)
      : points_(points), corner_uv_(patch.corner_uv), facets_(Tessellation(patch, points).facets) {
    std::vector<Aabb> boxes;
    for (const Facet& facet : facets_) {
      Aabb box;
      for (const Corner& corner : facet) box.join(corner.point);
      boxes.push_back(box);
      box_.join(box);
    }
    tree_ = Bvh(boxes);
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    if (tree_.empty()) return;
    const RayShear shear(ray.direction);
    const auto order = tree_.order();
    std::uint64_t box_tests = 0;
    tree_.traverse(ray, range, box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
      for (std::uint32_t i = first; i < first + count; ++i) {
        const Facet& f = facets_[order[i]];
        const dvec3 a = f[0].point - ray.origin;
        std::array<double, 3> weights;
        if (!shear.passes(a, f[1].point - ray.origin, f[2].point - ray.origin, weights)) continue;
        const dvec3 n = glm::cross(f[1].point - f[0].point, f[2].point - f[0].point);
        const double slope = glm::dot(n, ray.direction);
        if (std::abs(slope) < kEpsilon * glm::length(n)) continue;
        const double t = glm::dot(n, a) / slope;
        if (range.contains(t) && sink(t, order[i], weights)) far = std::min(far, t);
      }
      return false;
    });
  }

  Aabb bounds() const override { return box_; }
  bool inside(const dvec3&) const override { return false; }
  bool inside_inverted(const dvec3&) const override { return false; }
  bool is_patch() const override { return true; }
  bool obeys_clips() const override { return false; }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    dvec3 sum(0);
    for (std::size_t i = 0; i < 3; ++i) sum += hit.data[i] * surface_normal(facets_[hit.part][i].u, facets_[hit.part][i].v);
    return glm::dot(sum, sum) > kEpsilon ? glm::normalize(sum) : dvec3(1, 0, 0);
  }
  dvec2 uv(const ShapeHit& hit, const dvec3&) const override {
    double u = 0;
    double v = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      u += hit.data[i] * facets_[hit.part][i].u;
      v += hit.data[i] * facets_[hit.part][i].v;
    }
    const dvec2 bottom = corner_uv_[0] + v * (corner_uv_[1] - corner_uv_[0]);
    const dvec2 top = corner_uv_[3] + v * (corner_uv_[2] - corner_uv_[3]);
    return bottom + u * (top - bottom);
  }

 private:
  static std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  }
  static std::array<double, 4> bernstein_slope(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
  }

  dvec3 surface_normal(double u, double v) const {
    const std::array<double, 4> bu = bernstein(u), bv = bernstein(v), du = bernstein_slope(u), dv = bernstein_slope(v);
    dvec3 along_u(0);
    dvec3 along_v(0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        along_u += du[i] * bv[j] * points_[i][j];
        along_v += bu[i] * dv[j] * points_[i][j];
      }
    }
    const dvec3 n = glm::cross(along_u, along_v);
    const double squared = glm::dot(n, n);
    if (squared <= kEpsilon * glm::dot(along_u, along_u) * glm::dot(along_v, along_v)) return {1, 0, 0};
    return n / std::sqrt(squared);
  }

  Points points_;
  std::array<dvec2, 4> corner_uv_;
  std::vector<Facet> facets_;
  Aabb box_;
  Bvh tree_;
};

}  // namespace

std::unique_ptr<Shape> build(const BicubicPatch& patch, const Transform& to_world, BuildContext&) {
  Points points = patch.points;
  if (!to_world.identity())
    for (auto& row : points)
      for (dvec3& point : row) point = to_world.point(point);
  return std::make_unique<FacetedPatch>(patch, points);
}

}  // namespace lute
