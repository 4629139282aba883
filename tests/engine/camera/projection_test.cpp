#include "engine/camera/projection.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lute {
namespace {

// Chapter 30 §12 A: the direction probe. A unit sphere around the camera's place shows the hit point as 65535 (d + 1)
// / 2.
dvec3 probe(const Ray& ray) {
  const dvec3 d = glm::normalize(ray.direction);
  const double b = glm::dot(ray.origin, d), c = glm::dot(ray.origin, ray.origin) - 1;
  return 65535.0 * (ray.origin + d * (-b + std::sqrt(b * b - c)) + 1.0) / 2.0;
}

struct ProbeCase {
  const char* name;
  CameraKind kind;
  double angle;
  std::array<dvec3, 3> expected;  // at pixels (1,1), (4,2), (2,0)
};

class ProjectionProbe : public testing::TestWithParam<ProbeCase> {};

TEST_P(ProjectionProbe, PointsWhereTheReferencePoints) {
  Camera camera;
  camera.kind = GetParam().kind;
  camera.right = {1.5, 0, 0};
  camera.up = {0, 1.2, 0};
  camera.direction = {0, 0, 0.7};
  camera.angle = GetParam().angle;
  if (camera.kind == CameraKind::kSpherical) {
    camera.horizontal_angle = GetParam().angle;
    camera.vertical_angle = GetParam().angle / 2;
  }
  const Projection projection(camera, 6, 4);
  const std::array<dvec2, 3> pixels{{{1, 1}, {4, 2}, {2, 0}}};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ProjectedRay ray;
    ASSERT_TRUE(projection.project(pixels[i], ray));
    const dvec3 seen = probe({ray.origin, ray.direction});
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(seen[c], GetParam().expected[i][c], 1.0) << "pixel " << i << " channel " << c;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Chapter30CaseA, ProjectionProbe,
    testing::Values(ProbeCase{"perspective",
                              CameraKind::kPerspective,
                              0,
                              {{{17563, 38849, 61150}, {47972, 26686, 61150}, {27900, 50290, 60025}}}},
                    ProbeCase{"fisheye",
                              CameraKind::kFisheye,
                              180,
                              {{{3720, 44386, 42512}, {61815, 21149, 42512}, {24044, 64170, 36155}}}},
                    ProbeCase{"ultra_wide_angle",
                              CameraKind::kUltraWideAngle,
                              120,
                              {{{16472, 39544, 60376}, {49063, 25991, 60376}, {27107, 51928, 58739}}}},
                    ProbeCase{"omnimax",
                              CameraKind::kOmnimax,
                              0,
                              {{{12621, 48884, 52969}, {53923, 32768, 57790}, {26550, 62611, 44784}}}},
                    ProbeCase{"panoramic",
                              CameraKind::kPanoramic,
                              0,
                              {{{5436, 45576, 45522}, {60099, 19959, 45522}, {28527, 64409, 40152}}}},
                    ProbeCase{"cylinder_1",
                              CameraKind::kCylinder1,
                              100,
                              {{{19073, 37628, 62136}, {46462, 27907, 62136}, {28437, 46214, 62333}}}},
                    ProbeCase{"cylinder_2",
                              CameraKind::kCylinder2,
                              100,
                              {{{21262, 39408, 62721}, {44273, 26127, 62721}, {28703, 52561, 58563}}}},
                    ProbeCase{"cylinder_3",
                              CameraKind::kCylinder3,
                              100,
                              {{{19076, 37683, 62129}, {46459, 27852, 62129}, {28526, 47513, 61721}}}},
                    ProbeCase{"cylinder_4",
                              CameraKind::kCylinder4,
                              100,
                              {{{20480, 39342, 62424}, {45055, 26193, 62424}, {28672, 52559, 58560}}}},
                    ProbeCase{"spherical",
                              CameraKind::kSpherical,
                              200,
                              {{{8261, 39860, 53331}, {57274, 25675, 53331}, {25312, 52715, 57672}}}}),
    [](const auto& parameters) { return parameters.param.name; });

// Where a ray meets the plane z = 0.
dvec2 on_plane(const ProjectedRay& ray) {
  return dvec2(ray.origin) - dvec2(ray.direction) * (ray.origin.z / ray.direction.z);
}

TEST(Projection, OrthographicWidthIsThatOfRight) {  // chapter 30 §12 B
  Camera camera;
  camera.kind = CameraKind::kOrthographic;
  camera.location = {0, 0, -4};
  camera.right = {2, 0, 0};
  ProjectedRay ray;
  ASSERT_TRUE(Projection(camera, 4, 2).project({3, 0}, ray));
  EXPECT_NEAR(on_plane(ray).x, 0.750, 1e-9);
  EXPECT_NEAR(on_plane(ray).y, 0.250, 1e-9);
}

TEST(Projection, PerspectiveAngleSpansTheWidth) {  // chapter 30 §12 B, `angle 40`
  Camera camera;
  camera.location = {0, 0, -4};
  camera.direction = {0, 0, 1.33 / 2 / std::tan(radians(20))};
  ProjectedRay ray;
  ASSERT_TRUE(Projection(camera, 4, 2).project({3, 0}, ray));
  EXPECT_NEAR(on_plane(ray).x, 1.092, 5e-4);
  EXPECT_NEAR(on_plane(ray).y, 0.547, 5e-4);
}

TEST(Projection, FisheyeHasNoRayOutsideOfItsCircle) {
  Camera camera;
  camera.kind = CameraKind::kFisheye;
  camera.right = {1, 0, 0};
  ProjectedRay ray;
  const Projection projection(camera, 100, 100);
  EXPECT_FALSE(projection.project({0, 0}, ray));
  EXPECT_TRUE(projection.project({50, 50}, ray));
}

TEST(Projection, PositionsOutsideOfTheImageAreNotClamped) {
  ProjectedRay outside, edge;
  const Projection projection(Camera{}, 10, 10);
  projection.project({-1, -1}, outside);
  projection.project({0, 0}, edge);
  EXPECT_LT(outside.direction.x, edge.direction.x);
  EXPECT_GT(outside.direction.y, edge.direction.y);
}

}  // namespace
}  // namespace lute
