#include "engine/shape/mesh.hpp"

#include <algorithm>
#include <cmath>

#include "engine/accel/triangle_tree.hpp"

namespace lute {

namespace {

// Depths in the mesh's own units (specification chapter 21 §3.4).
constexpr double kMinDepth = 1e-6;
constexpr double kMaxDepth = 1e7;

// What all copies of a mesh share. Holds on to the data, whose address is the key that finds this.
struct SharedMesh {
  std::shared_ptr<const MeshData> data;
  TriangleTree tree;

  explicit SharedMesh(std::shared_ptr<const MeshData> mesh)
      : data(std::move(mesh)), tree(data->vertices, data->faces, [this](std::uint32_t face) {
          return data->face_normals[face] == glm::vec3(0);  // degenerate
        }) {}
};

// A ray in the mesh's space with unit direction, and how many of its units make one of the world.
struct LocalRay {
  Ray ray;
  double scale;
  Interval range;

  LocalRay(const Ray& world, Interval world_range, const Transform& to_world) : ray(world), scale(1) {
    if (!to_world.identity()) {
      ray = to_world.inverse_ray(world);
      scale = glm::length(ray.direction);
      ray.direction /= scale;
    }
    range = {std::max(world_range.lo * scale, kMinDepth), std::min(world_range.hi * scale, kMaxDepth)};
  }
};

class MeshShape final : public Shape {
 public:
  MeshShape(std::shared_ptr<const SharedMesh> shared, const dvec3& inside_vector, const SharedTransform& to_world)
      : shared_(std::move(shared)), mesh_(*shared_->data), to_world_(to_world) {
    const auto counts = [](double component) { return std::abs(component) >= kEpsilon; };
    is_patch_ = !(counts(inside_vector.x) || counts(inside_vector.y) || counts(inside_vector.z));
    if (!is_patch_) inside_vector_ = glm::normalize(inside_vector);
  }

  Aabb bounds() const override { return to_world_->box(shared_->tree.bounds()); }
  bool is_patch() const override { return is_patch_; }
  bool finds_bounds_fast() const override { return true; }

  bool nearest(const Ray& ray, Interval range, ShapeHit& hit) const override {
    const LocalRay local(ray, range, to_world_);
    TriangleHit found;
    if (!shared_->tree.nearest(local.ray, local.range, found)) return false;
    hit = world_hit(found, local, range);
    return true;
  }

  bool any(const Ray& ray, Interval range) const override {
    const LocalRay local(ray, range, to_world_);
    return shared_->tree.any(local.ray, local.range);
  }

  void hits(const Ray& ray, Interval range, ShapeHits& out) const override {
    const LocalRay local(ray, range, to_world_);
    thread_local std::vector<TriangleHit> found;
    found.clear();
    shared_->tree.all(local.ray, local.range, found);
    // The tree's order is nobody's business; nearest() takes the highest face of several at one depth, and so does the
    // last of the list.
    std::sort(found.begin(), found.end(),
              [](const TriangleHit& a, const TriangleHit& b) { return a.t < b.t || (a.t == b.t && a.face < b.face); });
    for (const TriangleHit& hit : found) out.push_back(world_hit(hit, local, range));
  }

  bool inside(const dvec3& point) const override {
    if (is_patch_) return false;
    const LocalRay local({point, inside_vector_}, {0, kMaxDepth}, to_world_);
    return shared_->tree.crossings(local.ray, {kMinDepth, kMaxDepth}) % 2 == 1;
  }
  bool inside_inverted(const dvec3& point) const override { return !is_patch_ && !inside(point); }

  dvec3 normal(const ShapeHit& hit, const dvec3&) const override {
    const dvec3 local = local_normal(hit);
    return to_world_.identity() ? local : glm::normalize(to_world_->normal(local));
  }

  dvec2 uv(const ShapeHit& hit, const dvec3&) const override {
    if (mesh_.uv_indices.empty() || mesh_.uvs.empty()) return dvec2(0);
    const MeshData::Indices& corners = mesh_.uv_indices[hit.part];
    return hit.data[0] * mesh_.uvs[corners[0]] + hit.data[1] * mesh_.uvs[corners[1]] +
           hit.data[2] * mesh_.uvs[corners[2]];
  }

  void textures(const ShapeHit& hit, const dvec3&, std::vector<TextureWeight>& out) const override {
    if (mesh_.texture_indices.empty() || mesh_.texture_indices[hit.part][0] == MeshData::kNone) {
      out.push_back({TextureWeight::kObjectTexture, 1});
      return;
    }
    const MeshData::Indices& corners = mesh_.texture_indices[hit.part];
    if (corners[1] == MeshData::kNone) {
      out.push_back({corners[0], 1});
      return;
    }
    for (std::size_t c = 0; c < 3; ++c) out.push_back({corners[c], static_cast<float>(hit.data[c])});
  }

 private:
  static ShapeHit world_hit(const TriangleHit& hit, const LocalRay& local, Interval range) {
    // The range was carried into the mesh's space; carrying the depth back may miss its ends by a rounding.
    return {std::clamp(hit.t / local.scale, range.lo, range.hi), hit.face, hit.weights};
  }

  dvec3 local_normal(const ShapeHit& hit) const {
    const dvec3 face_normal(mesh_.face_normals[hit.part]);
    if (mesh_.normal_indices.empty() || mesh_.normal_indices[hit.part][0] == MeshData::kNone)
      return glm::normalize(face_normal);
    const MeshData::Indices& corners = mesh_.normal_indices[hit.part];
    dvec3 sum(0);
    for (std::size_t c = 0; c < 3; ++c) sum += hit.data[c] * dvec3(mesh_.normals[corners[c]]);
    const double length = glm::length(sum);
    return length > 0 ? sum / length : glm::normalize(face_normal);
  }

  std::shared_ptr<const SharedMesh> shared_;
  const MeshData& mesh_;
  SharedTransform to_world_;
  dvec3 inside_vector_{0};  // world direction: it does not turn with the mesh (chapter 21 §3.5)
  bool is_patch_ = true;
};

}  // namespace

std::unique_ptr<Shape> build(const Mesh& mesh, const SharedTransform& to_world, BuildContext& context) {
  auto shared = std::static_pointer_cast<const SharedMesh>(context.find_shared(mesh.data.get()));
  if (!shared) {
    shared = std::make_shared<const SharedMesh>(mesh.data);
    context.store_shared(mesh.data.get(), shared);
  }
  return std::make_unique<MeshShape>(std::move(shared), mesh.inside_vector, to_world);
}

}  // namespace lute
