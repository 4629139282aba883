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

struct Cell {
  Points points;
  double u0, u1, v0, v1;
  int depth;
};

// How far a patch is divided (§5.2).
struct Division {
  double flatness;
  int u_steps, v_steps;

  explicit Division(const BicubicPatch& patch)
      : flatness(patch.flatness), u_steps(std::min(patch.u_steps, kDeepest)), v_steps(std::min(patch.v_steps, kDeepest)) {}

  bool ends_at(const Cell& c) const { return (c.depth >= u_steps && c.depth >= v_steps) || is_flat(c.points, flatness); }

  // Calls visit(cell) for the two or four parts of a cell.
  template <class Visit>
  void divide(const Cell& c, Visit&& visit) const {
    const double um = 0.5 * (c.u0 + c.u1);
    const double vm = 0.5 * (c.v0 + c.v1);
    const int depth = c.depth + 1;
    const auto divide_v = [&](const Points& points, double u0, double u1) {
      Points low, high;
      halve_v(points, low, high);
      visit(Cell{low, u0, u1, c.v0, vm, depth});
      visit(Cell{high, u0, u1, vm, c.v1, depth});
    };
    if (c.depth >= u_steps) return divide_v(c.points, c.u0, c.u1);
    Points low, high;
    halve_u(c.points, low, high);
    if (c.depth >= v_steps) {
      visit(Cell{low, c.u0, um, c.v0, c.v1, depth});
      visit(Cell{high, um, c.u1, c.v0, c.v1, depth});
      return;
    }
    divide_v(low, c.u0, um);
    divide_v(high, um, c.u1);
  }

 private:
  static constexpr int kDeepest = 48;  // what is left of a patch there is its rounding
};

// Calls sink(facet) for the triangles of a cell that is not divided further.
template <class Sink>
void facets_of(const Cell& cell, Sink&& sink) {
  const Points& p = cell.points;
  const Corner a{cell.u0, cell.v0, p[0][0]}, b{cell.u0, cell.v1, p[0][3]};
  const Corner c{cell.u1, cell.v1, p[3][3]}, d{cell.u1, cell.v0, p[3][0]};
  for (const Facet& f : {Facet{a, b, c}, Facet{a, c, d}}) {
    const dvec3 e = f[1].point - f[0].point;
    const dvec3 g = f[2].point - f[0].point;
    const dvec3 n = glm::cross(e, g);
    if (glm::dot(n, n) > kEpsilon * glm::dot(e, e) * glm::dot(g, g)) sink(f);
  }
}

// The parts of a patch: facets, and below a certain depth cells that are divided anew for every ray, as 4^10 of them would take
// gigabytes.
class Tessellation {
 public:
  Tessellation(const Division& division, const Points& points) : division_(division) { add({points, 0, 1, 0, 1, 0}); }
  std::vector<Facet> facets;
  std::vector<Cell> cells;

 private:
  static constexpr int kKeptDepth = 5;

  void add(const Cell& cell) {
    if (division_.ends_at(cell))
      facets_of(cell, [&](const Facet& f) { facets.push_back(f); });
    else if (cell.depth == kKeptDepth)
      cells.push_back(cell);
    else
      division_.divide(cell, [&](const Cell& part) { add(part); });
  }

  const Division& division_;
};

// A ray on its way through one patch.
class PatchRay {
 public:
  explicit PatchRay(const Ray& ray) : ray_(ray), shear_(ray.direction) {}

  bool meets(const Facet& f, double& t, std::array<double, 3>& weights) const {
    const dvec3 a = f[0].point - ray_.origin;
    if (!shear_.passes(a, f[1].point - ray_.origin, f[2].point - ray_.origin, weights)) return false;
    const dvec3 n = glm::cross(f[1].point - f[0].point, f[2].point - f[0].point);
    const double slope = glm::dot(n, ray_.direction);
    if (std::abs(slope) < kEpsilon * glm::length(n)) return false;
    t = glm::dot(n, a) / slope;
    return true;
  }

  // Whether the line may pass through the hull of the control points, which holds all facets: seen along it, they do not all lie to
  // one side.
  bool may_meet(const Points& points) const {
    double x_lo = 0, x_hi = 0, y_lo = 0, y_hi = 0, size = 0;
    bool first = true;
    for (const auto& row : points) {
      for (const dvec3& point : row) {
        const dvec3 p = point - ray_.origin;
        const double depth = p[shear_.k];
        const double x = p[shear_.i] - shear_.shear_i * depth;
        const double y = p[shear_.j] - shear_.shear_j * depth;
        x_lo = first ? x : std::min(x_lo, x);
        x_hi = first ? x : std::max(x_hi, x);
        y_lo = first ? y : std::min(y_lo, y);
        y_hi = first ? y : std::max(y_hi, y);
        size = std::max(size, std::abs(p[shear_.i]) + std::abs(p[shear_.j]) + std::abs(depth));
        first = false;
      }
    }
    constexpr double kGrain = 1e-14;  // rounding may put a facet's corner aside
    const double slack = kGrain * size;
    return x_lo <= slack && x_hi >= -slack && y_lo <= slack && y_hi >= -slack;
  }

 private:
  const Ray& ray_;
  RayShear shear_;
};

// A hit keeps the facet and the weights of its corners; in a divided cell the depth to which it was divided, and u and v.
class FacetedPatch final : public ScannedShape<FacetedPatch> {
 public:
  FacetedPatch(const BicubicPatch& patch, const Points& points)
      : points_(points), corner_uv_(patch.corner_uv), division_(patch) {
    Tessellation parts(division_, points);
    facets_ = std::move(parts.facets);
    cells_ = std::move(parts.cells);
    std::vector<Aabb> boxes;
    for (const Facet& facet : facets_) {
      Aabb& box = boxes.emplace_back();
      for (const Corner& corner : facet) box.join(corner.point);
    }
    for (const Cell& cell : cells_) {
      Aabb& box = boxes.emplace_back();
      for (const auto& row : cell.points)
        for (const dvec3& point : row) box.join(point);
    }
    for (const Aabb& box : boxes) box_.join(box);
    tree_ = Bvh(boxes);
  }

  template <class Sink>
  void scan(const Ray& ray, Interval range, Sink&& sink) const {
    if (tree_.empty()) return;
    const PatchRay patch_ray(ray);
    const auto order = tree_.order();
    std::uint64_t box_tests = 0;
    tree_.traverse(ray, range, box_tests, [&](std::uint32_t first, std::uint32_t count, double& far) {
      for (std::uint32_t i = first; i < first + count; ++i) {
        if (order[i] >= facets_.size()) {
          scan_cell(cells_[order[i] - facets_.size()], patch_ray, range, far, sink);
          continue;
        }
        double t;
        std::array<double, 3> weights;
        if (!patch_ray.meets(facets_[order[i]], t, weights)) continue;
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
    for (const Weighted& corner : corners(hit)) sum += corner.weight * surface_normal(corner.u, corner.v);
    return glm::dot(sum, sum) > kEpsilon ? glm::normalize(sum) : dvec3(1, 0, 0);
  }
  dvec2 uv(const ShapeHit& hit, const dvec3&) const override {
    double u = 0;
    double v = 0;
    for (const Weighted& corner : corners(hit)) {
      u += corner.weight * corner.u;
      v += corner.weight * corner.v;
    }
    const dvec2 bottom = corner_uv_[0] + v * (corner_uv_[1] - corner_uv_[0]);
    const dvec2 top = corner_uv_[3] + v * (corner_uv_[2] - corner_uv_[3]);
    return bottom + u * (top - bottom);
  }

 private:
  struct Weighted {
    double weight, u, v;
  };
  static constexpr std::uint32_t kDivided = 1u << 31;  // with the depth: the part of a hit in a divided cell

  template <class Sink>
  void scan_cell(const Cell& cell, const PatchRay& ray, Interval range, double& far, Sink& sink) const {
    if (!ray.may_meet(cell.points)) return;
    if (!division_.ends_at(cell))
      return division_.divide(cell, [&](const Cell& part) { scan_cell(part, ray, range, far, sink); });
    facets_of(cell, [&](const Facet& f) {
      double t;
      std::array<double, 3> w;
      if (!ray.meets(f, t, w) || !range.contains(t)) return;
      const double u = w[0] * f[0].u + w[1] * f[1].u + w[2] * f[2].u;
      const double v = w[0] * f[0].v + w[1] * f[1].v + w[2] * f[2].v;
      if (sink(t, kDivided | static_cast<std::uint32_t>(cell.depth), std::array<double, 3>{u, v, 0})) far = std::min(far, t);
    });
  }

  // The corners of the facet that was hit. Facets side by side agree on their edge, so that rounding may take either.
  std::array<Weighted, 3> corners(const ShapeHit& hit) const {
    std::array<Weighted, 3> result;
    if (!(hit.part & kDivided)) {
      const Facet& facet = facets_[hit.part];
      for (std::size_t i = 0; i < 3; ++i) result[i] = {hit.data[i], facet[i].u, facet[i].v};
      return result;
    }
    const int depth = static_cast<int>(hit.part & ~kDivided);
    const double cells_u = std::ldexp(1.0, std::min(depth, division_.u_steps));
    const double cells_v = std::ldexp(1.0, std::min(depth, division_.v_steps));
    const double u = hit.data[0] * cells_u, v = hit.data[1] * cells_v;
    const double u0 = std::clamp(std::floor(u), 0.0, cells_u - 1), v0 = std::clamp(std::floor(v), 0.0, cells_v - 1);
    const double along_u = u - u0, along_v = v - v0;
    const bool upper = along_v >= along_u;  // the facet with the corner (u0, v1), not that with (u1, v0)
    result[0] = {1 - std::max(along_u, along_v), u0 / cells_u, v0 / cells_v};
    result[1] = {std::min(along_u, along_v), (u0 + 1) / cells_u, (v0 + 1) / cells_v};
    result[2] = {std::abs(along_v - along_u), (upper ? u0 : u0 + 1) / cells_u, (upper ? v0 + 1 : v0) / cells_v};
    return result;
  }

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
  Division division_;
  std::vector<Facet> facets_;
  std::vector<Cell> cells_;  // to be divided further
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
