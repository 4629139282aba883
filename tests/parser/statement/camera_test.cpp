// The arithmetic of cameras (specification chapters 11 §4 and 30 §2.3).
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

Camera camera_of(const std::string& items) { return scene_of(kVersion + "camera { " + items + " }").camera; }

void expect_near(const dvec3& a, const dvec3& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12);
}

TEST(Cameras, DefaultsAreThoseOfTheLanguage) {  // case 16
  const Camera camera = camera_of("");
  expect_near(camera.right, {1.33, 0, 0});
  expect_near(camera.direction, {0, 0, 1});
  EXPECT_EQ(camera.focal_distance, 1);
}

TEST(Cameras, TheOrderOfItemsDoesNotMatter) {  // case 13
  const std::string items[] = {"location <0,0,-5> angle 90 right x*2 up y*1.5 look_at 0", "look_at 0 up y*1.5 angle 90 right x*2 location <0,0,-5>"};
  for (const std::string& written : items) {
    const Camera camera = camera_of(written);
    expect_near(camera.direction, {0, 0, 1});  // |right| / (2 tan 45°)
    expect_near(camera.right, {2, 0, 0});
    expect_near(camera.up, {0, 1.5, 0});
  }
}

TEST(Cameras, TransformationsActLast) {  // case 14
  const Camera camera = camera_of("rotate 90*y location <0,0,-5> look_at 0 right x*2 up y*1.5");
  expect_near(camera.location, {-5, 0, 0});
  expect_near(camera.direction, {1, 0, 0});
  expect_near(camera.right, {0, 0, -2});
}

TEST(Cameras, OrthographicIsScaledToTheDistanceUnlessItsFrameIsWritten) {  // case 15
  expect_near(camera_of("orthographic location <0,0,-5> look_at 0").right, {1.33 * 5, 0, 0});
  expect_near(camera_of("orthographic location <0,0,-5> look_at 0 right 4*x").right, {4, 0, 0});
}

TEST(Cameras, ALeftHandedFrameStaysLeftHanded) {
  EXPECT_LT(camera_of("right -x*1.33 look_at z").right.x, 0);
}

TEST(Cameras, OldCamerasActInOrder) {  // case 17: the angle sees the right vector of its moment
  const std::string version = "#version 3.1; ";
  const Camera early = scene_of(version + "camera { location -5*z angle 90 right 2*x up 1.5*y look_at 0 }").camera;
  const Camera late = scene_of(version + "camera { location -5*z right 2*x up 1.5*y look_at 0 angle 90 }").camera;
  expect_near(early.direction, {0, 0, 0.665});
  expect_near(late.direction, {0, 0, 1});
}

TEST(Cameras, TypesComeFirst) {
  EXPECT_EQ(rejection_of(kVersion + "camera { location 0 orthographic }"),
            "Expected 'perspective camera modifier', orthographic found instead");
  EXPECT_EQ(rejection_of(kVersion + "camera { angle 180 }"), "Viewing angle has to be smaller than 180 degrees.");
  EXPECT_EQ(rejection_of(kVersion + "camera { location 1 look_at 1 }"), "Camera location and look_at point must be different.");
}

TEST(Cameras, TheLastOneCounts) {
  const std::string two = kVersion + "camera { location x } camera { location y }";
  expect_near(scene_of(two).camera.location, {0, 1, 0});
  EXPECT_TRUE(warns(two, "More than one camera in scene. Ignoring previous camera(s)."));
}

TEST(MeshCameras, TakeMeshesAndNamesOfMeshes) {
  const std::string names = "#declare M = mesh { triangle { 0, x, y } } #declare S = sphere { 0, 1 } ";
  const auto text = [&](const std::string& body) { return kVersion + names + "camera { mesh_camera { " + body + " } }"; };
  const Camera camera = scene_of(text("2 0 5 mesh { M translate z } mesh2 { M }")).camera;
  ASSERT_NE(camera.mesh, nullptr);
  EXPECT_EQ(camera.mesh->rays, 2);
  EXPECT_EQ(camera.mesh->reach, 5);
  ASSERT_EQ(camera.mesh->parts.size(), 2u);
  expect_near(camera.mesh->parts[0].transform.point(dvec3(0)), {0, 0, 1});
  EXPECT_EQ(rejection_of(text("1 0 mesh { S }")), "A mesh camera needs meshes.");
}

TEST(MeshCameras, RejectWhatTheReferenceRejects) {  // the messages are those of the reference's binary
  const auto rejection = [](const std::string& body) {
    return rejection_of(kVersion + "#declare M = mesh { triangle { 0, x, y } } camera { mesh_camera { " + body + " } }");
  };
  EXPECT_EQ(rejection("0 0 mesh { M }"), "Rays per pixel may not be 0");
  EXPECT_EQ(rejection("2 0 mesh { M }"), "Rays per pixel must be <= number of meshes for distribution method #0");
  EXPECT_EQ(rejection("1 4 mesh { M }"), "Unrecognized distribution method");
  EXPECT_EQ(rejection("2 3 mesh { M }"), "Rays per pixel must be 1 for distribution method #2 or #3");
  EXPECT_EQ(rejection("1 2 mesh { M } smooth"), "Smooth can only be used with distribution method #3");
  EXPECT_EQ(rejection("1 0 mesh { M }, mesh { M }"), "No matching } in 'mesh_camera', ,  found instead");
  EXPECT_EQ(rejection("1 0 mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } }"), "No triangles in triangle mesh.");
  EXPECT_EQ(rejection("1 0"), "Expected 'mesh or mesh2', } found instead");
}

TEST(Cameras, FocalPointMeasuresFromTheLocation) {
  EXPECT_EQ(camera_of("location -5*z focal_point 0 aperture 0.1 blur_samples 10").focal_distance, 5);
  EXPECT_EQ(rejection_of(kVersion + "camera { blur_samples 0 }"), "Illegal number of focal blur samples.");
}

}  // namespace
}  // namespace lute::test
