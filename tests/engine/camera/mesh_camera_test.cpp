// Check case C of the specification's chapter 30 §12, and its §3.2.
#include "engine/camera/mesh_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lute {
namespace {

// Face i is <i,0,0>, <i+.3,0,0>, <i,.3,0>: its normal is -z.
std::shared_ptr<const MeshData> row_of_faces(int count) {
  auto mesh = std::make_shared<MeshData>();
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    const auto first = static_cast<std::uint32_t>(mesh->vertices.size());
    mesh->vertices.insert(mesh->vertices.end(), {{x, 0, 0}, {x + 0.3f, 0, 0}, {x, 0.3f, 0}});
    mesh->faces.push_back({first, first + 1, first + 2});
    mesh->face_normals.emplace_back(0, 0, -1);
  }
  return mesh;
}

Camera camera_of(MeshCamera mesh) {
  Camera camera;
  camera.kind = CameraKind::kMesh;
  camera.mesh = std::make_shared<const MeshCamera>(std::move(mesh));
  return camera;
}

// The faces that the pixels see, as letters; '.' where there is no ray. Those of meshes moved by 20 are capital.
std::string faces_seen(const Camera& camera, int width, int height, int ray_index = 0) {
  const MeshCameraRays rays(camera, width, height);
  std::string seen;
  for (int y = 0; y < height; ++y, seen += ' ')
    for (int x = 0; x < width; ++x) {
      ProjectedRay ray;
      const bool found = rays.project({x, y}, ray_index, ray);
      const int face = static_cast<int>(std::floor(ray.origin.x));
      seen += !found ? '.' : static_cast<char>(face >= 20 ? 'A' + face - 20 : 'a' + face);
    }
  return seen;
}

TEST(MeshCamera, TheFirstTwoRowsSeeTheSameFaces) {
  MeshCamera mesh;
  mesh.parts = {{row_of_faces(14), {}}};
  EXPECT_EQ(faces_seen(camera_of(mesh), 4, 4), "abcd abcd efgh ijkl ");
  EXPECT_EQ(faces_seen(camera_of(mesh), 8, 3), "abcdefgh abcdefgh ijklmn.. ") << "beyond the last face there is no ray";
}

TEST(MeshCamera, RayNLeavesFromMeshN) {
  MeshCamera mesh;
  mesh.rays = 2;
  mesh.parts = {{row_of_faces(14), {}}, {row_of_faces(6), Transform::translate({20, 0, 0})}};
  EXPECT_EQ(faces_seen(camera_of(mesh), 4, 3, 1), "ABCD ABCD EF.. ");
}

TEST(MeshCamera, AllFacesInARow) {
  MeshCamera mesh;
  mesh.distribution = MeshCamera::Distribution::kAllInARow;
  mesh.parts = {{row_of_faces(3), {}}, {row_of_faces(6), Transform::translate({20, 0, 0})}};
  EXPECT_EQ(faces_seen(camera_of(mesh), 4, 3), "abcA abcA BCDE ");
}

TEST(MeshCamera, MeshesSideBySide) {
  MeshCamera mesh;
  mesh.distribution = MeshCamera::Distribution::kSideBySide;
  const Transform aside = Transform::translate({20, 0, 0});
  mesh.parts = {{row_of_faces(14), {}}, {row_of_faces(14), aside}};
  EXPECT_EQ(faces_seen(camera_of(mesh), 6, 4), "abcDEF abcDEF defGHI ghiJKL ");
}

TEST(MeshCamera, RaysLeaveAlongTheNormalFromAnOffset) {
  MeshCamera mesh;
  mesh.parts = {{row_of_faces(1), Transform::translate({0, 0, 5})}};
  mesh.reach = 7;
  Camera camera = camera_of(mesh);
  camera.location = {0, 0, 0.5};
  ProjectedRay ray;
  ASSERT_TRUE(MeshCameraRays(camera, 1, 1).project({0, 0}, 0, ray));
  EXPECT_NEAR(glm::distance(ray.origin, dvec3(0.1, 0.1, 4.5)), 0, 1e-7);
  EXPECT_EQ(ray.direction, dvec3(0, 0, -1));
  EXPECT_EQ(ray.reach, 7);
  camera.direction = {0, 0, -1};
  ASSERT_TRUE(MeshCameraRays(camera, 1, 1).project({0, 0}, 0, ray));
  EXPECT_NEAR(ray.origin.z, 4.5, 1e-7) << "the offset keeps its side";
  EXPECT_EQ(ray.direction, dvec3(0, 0, 1));
}

// The unit square as two smooth faces whose uv are their x and y.
MeshCamera mapped_square() {
  auto mesh = std::make_shared<MeshData>();
  mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh->faces = mesh->uv_indices = {{0, 1, 2}, {0, 2, 3}};
  mesh->face_normals = {{0, 0, -1}, {0, 0, -1}};
  for (const auto& v : mesh->vertices) mesh->uvs.emplace_back(v.x, v.y);
  mesh->normals = {{0, 0, -1}, {1, 0, 0}};
  mesh->normal_indices = {{0, 1, 0}, {0, 0, 0}};
  MeshCamera camera;
  camera.distribution = MeshCamera::Distribution::kUvMap;
  camera.parts = {{mesh, {}}};
  return camera;
}

TEST(MeshCamera, SamplesTheUvMap) {
  const MeshCameraRays rays(camera_of(mapped_square()), 4, 3);
  const double u[] = {0, 0.25, 0.5, 0.625}, v[] = {2.5 / 3, 2.0 / 3, 1.0 / 3};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      ProjectedRay ray;
      ASSERT_TRUE(rays.project({x, y}, 0, ray));
      EXPECT_NEAR(ray.origin.x, u[x], 1e-7);
      EXPECT_NEAR(ray.origin.y, v[y], 1e-7);
    }
}

TEST(MeshCamera, SmoothBlendsTheNormalsOfTheCorners) {
  MeshCamera mesh = mapped_square();
  const auto direction = [](const MeshCamera& m) {
    ProjectedRay ray;
    EXPECT_TRUE(MeshCameraRays(camera_of(m), 4, 3).project({2, 2}, 0, ray));  // (1/2, 1/3): weights 1/2, 1/6, 1/3
    return ray.direction;
  };
  EXPECT_EQ(direction(mesh), dvec3(0, 0, -1));
  mesh.smooth = true;
  EXPECT_NEAR(glm::distance(direction(mesh), glm::normalize(dvec3(1, 0, -5))), 0, 1e-7);
}

}  // namespace
}  // namespace lute
