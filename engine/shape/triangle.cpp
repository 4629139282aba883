#include "engine/shape/triangle.hpp"

#include <cmath>

#include "engine/shape/empty_shape.hpp"
#include "engine/shape/scanned_shape.hpp"
#include "engine/shape/watertight_triangle.hpp"

namespace lute {

namespace {

constexpr double kMaxDepth = 1e7;

// The hit keeps the barycentric weights of the corners.
class Facet final : public ScannedShape<Facet> {
 public:
  Facet(const std::array<dvec3, 3>& vertices, const std::array<dvec3, 3>& vertex_normals, bool smooth)
      : vertices_(vertices),
        normal_(glm::normalize(glm::cross(vertices[0] - vertices[1], vertices[2] - vertices[1]))),
        vertex_normals_(vertex_normals),
        smooth_(smooth) {}

  template <class Sink>
  void scan(const Ray& ray, Interval, Sink&& sink) const {
    const double slope = glm::dot(normal_, ray.direction);
    if (std::abs(slope) < kEpsilon) return;
    const dvec3 a = vertices_[0] - ray.origin;
    const double t = glm::dot(normal_, a) / slope;
    if (!(t <= kMaxDepth)) return;
    std::array<double, 3> weights;
    if (RayShear(ray.direction).passes(a, vertices_[1] - ray.origin, vertices_[2] - ray.origin, weights)) sink(t, 0, weights);
  }

  Aabb bounds() const override {
    Aabb box;
    for (const dvec3& vertex : vertices_) box.join(vertex);
    return box;
  }
  bool inside(const dvec3&) const override { return false; }
  bool inside_inverted(const dvec3&) const override { return false; }
  bool is_patch() const override { return true; }
  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    if (!smooth_) return normal_;
    dvec3 sum(0);
    for (std::size_t i = 0; i < 3; ++i) sum += hit.data[i] * vertex_normals_[i];
    return glm::normalize(sum);
  }

 private:
  std::array<dvec3, 3> vertices_;
  dvec3 normal_;
  std::array<dvec3, 3> vertex_normals_;
  bool smooth_;
};

std::array<dvec3, 3> moved(const std::array<dvec3, 3>& vertices, const Transform& to_world) {
  std::array<dvec3, 3> result = vertices;
  if (!to_world.identity())
    for (dvec3& vertex : result) vertex = to_world.point(vertex);
  return result;
}

}  // namespace

std::unique_ptr<Shape> build(const Triangle& triangle, const Transform& to_world, BuildContext&) {
  const std::array<dvec3, 3>& v = triangle.vertices;
  if (glm::cross(v[0] - v[1], v[2] - v[1]) == dvec3(0)) return build_empty_shape(true);
  return std::make_unique<Facet>(moved(v, to_world), std::array<dvec3, 3>{}, false);
}

std::unique_ptr<Shape> build(const SmoothTriangle& triangle, const Transform& to_world, BuildContext&) {
  const std::array<dvec3, 3>& v = triangle.vertices;
  const dvec3 face = glm::cross(v[0] - v[1], v[2] - v[1]);
  int in_front = 0;
  int behind = 0;
  std::array<dvec3, 3> normals{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = glm::dot(face, triangle.normals[i]);
    in_front += side > 0;
    behind += side < 0;
    if (side == 0) continue;
    normals[i] = glm::normalize(triangle.normals[i]);
    if (to_world.identity()) continue;
    normals[i] = to_world.normal(normals[i]);
    // A matrix leaves the normals as long as it makes them: their lengths are weights (specification chapter 21 §2.3).
    if (!(to_world.kinds & Transform::kMatrix)) normals[i] = glm::normalize(normals[i]);
  }
  if (in_front != 3 && behind != 3) return build_empty_shape(true);
  return std::make_unique<Facet>(moved(v, to_world), normals, true);
}

}  // namespace lute
