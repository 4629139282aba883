#include "engine/shape/polygon.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "engine/shape/empty_shape.hpp"
#include "engine/shape/scanned_shape.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;
constexpr double kPlanar = 1e-9;  // share of the polygon's size that a point may be off its plane

bool same_point(const dvec3& a, const dvec3& b) {
  const dvec3 d = glm::abs(a - b);
  return d.x < kEpsilon && d.y < kEpsilon && d.z < kEpsilon;
}

struct Edge {
  dvec3 from, to;
};

std::vector<Edge> edges_of(const std::vector<dvec3>& p, bool& closed) {
  std::vector<Edge> edges;
  closed = true;
  for (std::size_t i = 0; i < p.size();) {
    const dvec3 start = p[i];
    std::size_t k = i + 1;
    while (k < p.size() && !same_point(p[k], start)) {
      edges.push_back({p[k - 1], p[k]});
      ++k;
    }
    closed = k < p.size();
    edges.push_back({p[k - 1], start});
    i = k + 1;
  }
  return edges;
}

// Axes in the plane of the points, and its normal; false if there is no such plane.
bool find_axes(const std::vector<dvec3>& p, dvec3& a, dvec3& b, dvec3& w) {
  double size = 0;
  for (const dvec3& point : p) size = std::max(size, glm::length(point - p[0]));
  const double small = kEpsilon * size * size;
  std::size_t i = 1;
  while (i < p.size() && glm::dot(p[i] - p[0], p[i] - p[0]) <= small) ++i;
  if (i >= p.size()) return false;
  const dvec3 e1 = p[i] - p[0];
  for (++i; i < p.size(); ++i) {
    const dvec3 e2 = p[i] - p[0];
    w = glm::cross(e1, e2);
    if (glm::dot(e2, e2) <= small || glm::dot(w, w) <= small * size * size) continue;
    a = glm::normalize(glm::cross(e1, w));
    w = glm::normalize(w);
    b = glm::cross(w, a);
    return std::ranges::all_of(p, [&](const dvec3& q) { return std::abs(glm::dot(q - p[0], w)) <= kPlanar * size; });
  }
  return false;
}

class FlatPolygon final : public ScannedShape<FlatPolygon> {
 public:
  FlatPolygon(const std::vector<dvec3>& points, const dvec3& a, const dvec3& b, const dvec3& w, const SharedTransform& to_world)
      : origin_(to_world->point(points[0])), normal_(glm::normalize(to_world->normal(w))), to_world_(to_world), axis_a_(a), axis_b_(b) {
    local_origin_ = points[0];
    bool closed = true;
    for (const Edge& edge : edges_of(points, closed)) edges_.push_back({planar(edge.from), planar(edge.to)});
    for (const dvec3& point : points) box_.join(to_world->point(point));
  }

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const double slope = glm::dot(normal_, ray.direction);
    if (std::abs(slope) < kEpsilon) return;
    const double t = glm::dot(normal_, origin_ - ray.origin) / slope;
    if (t <= kMaxDepth && contains(planar(to_world_->inverse_point(ray.at(t))))) sink(t, 0);
  }

  Aabb bounds() const override { return box_; }
  bool inside(const dvec3&) const override { return false; }
  bool inside_inverted(const dvec3&) const override { return false; }
  bool is_patch() const override { return true; }
  dvec3 normal(const ShapeHit&, const dvec3&) const override { return normal_; }

 private:
  struct PlanarEdge {
    dvec2 from, to;
  };

  dvec2 planar(const dvec3& p) const { return {glm::dot(p - local_origin_, axis_a_), glm::dot(p - local_origin_, axis_b_)}; }

  bool contains(const dvec2& p) const {
    bool odd = false;
    for (const PlanarEdge& e : edges_) {
      const bool to_above = e.to.y >= p.y;
      if ((e.from.y >= p.y) == to_above) continue;
      odd ^= ((e.to.y - p.y) * (e.from.x - e.to.x) >= (e.to.x - p.x) * (e.from.y - e.to.y)) == to_above;
    }
    return odd;
  }

  dvec3 origin_, normal_;
  SharedTransform to_world_;
  dvec3 local_origin_{0}, axis_a_, axis_b_;
  std::vector<PlanarEdge> edges_;
  Aabb box_;
};

}  // namespace

bool polygon_is_closed(const Polygon& polygon) {
  bool closed = true;
  edges_of(polygon.points, closed);
  return closed;
}

std::unique_ptr<Shape> build(const Polygon& polygon, const SharedTransform& to_world, BuildContext&) {
  dvec3 a, b, w;
  if (polygon.points.size() < 3 || !find_axes(polygon.points, a, b, w)) return build_empty_shape(true);
  return std::make_unique<FlatPolygon>(polygon.points, a, b, w, to_world);
}

}  // namespace lute
