// Numbers: specification chapter 21 §12, check cases 2 and 4.
#include "engine/shape/mesh.hpp"

#include <gtest/gtest.h>

#include <map>

#include "engine/shape/triangle.hpp"
#include "trace.hpp"

namespace lute {
namespace {

using test::make;
using Indices = MeshData::Indices;

std::shared_ptr<MeshData> mesh_of(std::vector<glm::vec3> vertices, std::vector<Indices> faces) {
  auto data = std::make_shared<MeshData>();
  data->vertices = std::move(vertices);
  data->faces = std::move(faces);
  for (const Indices& f : data->faces) {
    const glm::vec3 a = data->vertices[f[0]];
    const glm::vec3 n = glm::cross(data->vertices[f[2]] - a, data->vertices[f[1]] - a);
    data->face_normals.push_back(glm::length(n) > 0 ? glm::normalize(n) : glm::vec3(0));
  }
  return data;
}

std::shared_ptr<MeshData> smooth_triangle(const std::array<glm::vec3, 3>& normals) {
  auto data = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  for (const glm::vec3& n : normals) data->normals.push_back(glm::normalize(n));
  data->normal_indices = {{0, 1, 2}};
  return data;
}

std::shared_ptr<MeshData> cube() {
  std::vector<glm::vec3> corners;
  for (int c = 0; c < 8; ++c) corners.emplace_back(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
  return mesh_of(corners, {{0, 1, 3},
                           {0, 3, 2},
                           {4, 5, 7},
                           {4, 7, 6},
                           {0, 1, 5},
                           {0, 5, 4},
                           {2, 3, 7},
                           {2, 7, 6},
                           {0, 2, 6},
                           {0, 6, 4},
                           {1, 3, 7},
                           {1, 7, 5}});
}

TEST(Mesh, SmoothNormalsAsMeasured) {
  const auto shape = make(Mesh{smooth_triangle({glm::vec3(0, 0, 1), {0, 0, -1}, {0, 1, -1}})});
  EXPECT_TRACE(*shape, dvec3(0.25, 0.25, -1), dvec3(0, 0, 1), dvec3(0.25, 0.25, 0), dvec3(0, 0.923880, 0.382683));
}

TEST(Mesh, ScaledSmoothNormalsAreInterpolatedBeforeTheyAreTransformed) {
  const auto shape =
      make(Mesh{smooth_triangle({glm::vec3(-1, 0, -1), {1, 0, -1}, {0, 1, -1}})}, Transform::scale({2, 1, 3}));
  EXPECT_TRACE(*shape, dvec3(0.5, 0.25, -1), dvec3(0, 0, 1), dvec3(0.5, 0.25, 0),
               dvec3(-0.287348, 0.574696, -0.766261));
}

TEST(Mesh, NormalIndicesMakeSomeFacesSmooth) {
  auto data = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  data->normals = {{0, 0, -1}, glm::normalize(glm::vec3(1, 0, -1))};
  data->normal_indices = {{0, 1, 0}, {MeshData::kNone, MeshData::kNone, MeshData::kNone}};
  const auto shape = make(Mesh{data});
  EXPECT_TRACE(*shape, dvec3(0.25, 0.25, -1), dvec3(0, 0, 1), dvec3(0.25, 0.25, 0), dvec3(0.187366, 0, -0.982290));
  EXPECT_TRACE(*shape, dvec3(0.75, 0.75, -1), dvec3(0, 0, 1), dvec3(0.75, 0.75, 0), dvec3(0, 0, -1));
}

TEST(Mesh, UvIsInterpolatedByBarycentricWeights) {
  auto data = mesh_of({{-2, -3, 0}, {0, -3, 0}, {-2, 3, 0}}, {{0, 1, 2}});
  data->uvs = {{0, 0}, {1, 0}, {0, 1}};
  data->uv_indices = {{0, 1, 2}};
  const auto shape = make(Mesh{data}, Transform::translate({0, 0, 4}));
  ShapeHit hit;
  ASSERT_TRUE(shape->nearest({{-1.75, 2.25, 0}, {0, 0, 1}}, {1e-4, 1e7}, hit));
  const dvec2 uv = shape->uv(hit, {});
  EXPECT_NEAR(uv.x, 0.125, 1e-12);
  EXPECT_NEAR(uv.y, 0.875, 1e-12);
}

// 8-bit linear colours 85, 32, 138 of a red, a green and a blue corner.
TEST(Mesh, ThreeTexturesShareThePointByBarycentricWeights) {
  auto data = mesh_of({{2, -3, 0}, {4, -3, 0}, {2, 3, 0}}, {{0, 1, 2}});
  data->texture_indices = {{7, 8, 9}};
  const auto shape = make(Mesh{data});
  ShapeHit hit;
  ASSERT_TRUE(shape->nearest({{2.25, 0.25, -1}, {0, 0, 1}}, {1e-4, 1e7}, hit));
  std::vector<TextureWeight> textures;
  shape->textures(hit, {}, textures);
  ASSERT_EQ(textures.size(), 3u);
  const double expected[] = {85, 32, 138};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(textures[i].index, 7 + i);
    EXPECT_NEAR(255.0 * static_cast<double>(textures[i].weight), expected[i], 0.51);
  }
}

TEST(Mesh, WithInsideVectorIsSolid) {
  const auto solid = make(Mesh{cube(), {0.3, 0.2, 1}});
  EXPECT_FALSE(solid->is_patch());
  EXPECT_TRUE(solid->inside({0.1, 0, 0.2}));
  EXPECT_FALSE(solid->inside({2, 0, 0}));
  EXPECT_TRUE(solid->inside_inverted({2, 0, 0}));
  const auto patch = make(Mesh{cube()});
  EXPECT_TRUE(patch->is_patch());
  EXPECT_FALSE(patch->inside({0.1, 0, 0.2}));
  EXPECT_FALSE(patch->inside_inverted({0.1, 0, 0.2}));
}

TEST(Mesh, ReportsAllHitsInWorldDepths) {
  const auto shape =
      make(Mesh{cube(), {0.3, 0.2, 1}}, Transform::scale(dvec3(3)).then(Transform::translate({10, 0, 0})));
  ShapeHits hits;
  shape->hits({{0, 0.3, 0.2}, {1, 0, 0}}, {1e-4, 1e7}, hits);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].t, 7, 1e-12);
  EXPECT_NEAR(hits[1].t, 13, 1e-12);
  hits.clear();
  shape->hits({{0, 0.3, 0.2}, {1, 0, 0}}, {8, 12}, hits);
  EXPECT_TRUE(hits.empty());
  EXPECT_TRUE(shape->any({{0, 0.3, 0.2}, {1, 0, 0}}, {8, 13.5}));
  EXPECT_FALSE(shape->any({{0, 0.3, 0.2}, {1, 0, 0}}, {8, 12.5}));
}

TEST(Mesh, DegenerateFacesAreNeverHit) {
  const auto shape = make(Mesh{mesh_of({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, {{0, 1, 2}})});
  ShapeHit hit;
  EXPECT_FALSE(shape->nearest({{1, 1, -1}, {0, 0, 1}}, {1e-4, 1e7}, hit));
  EXPECT_TRUE(shape->bounds().empty());
}

TEST(Mesh, CopiesShareOneTree) {
  class Context final : public BuildContext {
   public:
    std::shared_ptr<const void> find_shared(const void* key) const override {
      const auto at = stored.find(key);
      return at == stored.end() ? nullptr : at->second;
    }
    void store_shared(const void* key, std::shared_ptr<const void> value) override { stored[key] = std::move(value); }
    std::map<const void*, std::shared_ptr<const void>> stored;
  } context;
  const Mesh mesh{cube()};
  const auto a = build(mesh, Transform(), context);
  const auto b = build(mesh, Transform::translate({5, 0, 0}), context);
  EXPECT_EQ(context.stored.size(), 1u);
  EXPECT_TRUE(b->any({{5, 0, -3}, {0, 0, 1}}, {1e-4, 1e7}));
  EXPECT_FALSE(a->any({{5, 0, -3}, {0, 0, 1}}, {1e-4, 1e7}));
}

}  // namespace
}  // namespace lute
