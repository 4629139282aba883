// Where the ray of an image position starts and points, for every camera type. mesh_camera is the only one with several rays of
// one position (engine/camera/mesh_camera.hpp).
//
// Image positions are in pixels: (0, 0) is the centre of the top left pixel, x to the right, y down. They may be
// fractional and may lie outside the image (antialiasing asks for column and row -1). Width and height are those of the
// whole image, also for partial renders. Some types have no ray at some positions (fisheye and omnimax outside of their
// circle). Source: specification chapter 30 §1, §3.
#pragma once

#include <optional>

#include "engine/camera/mesh_camera.hpp"
#include "engine/camera/projected_ray.hpp"
#include "engine/math/ray.hpp"
#include "engine/math/vec.hpp"
#include "engine/scene/camera.hpp"

namespace lute {

// The camera's vectors with what every type derives from them. Angles in radians.
struct View {
  dvec3 location, direction, right, up;
  dvec3 unit_direction, unit_right, unit_up;
  double right_length, up_length;
  double angle, horizontal_angle, vertical_angle;
};

class Projection {
 public:
  Projection(const Camera& camera, int width, int height);

  int rays_per_position() const { return mesh_ ? mesh_->rays_per_position() : 1; }

  // False: the camera has no ray `index` at this position.
  bool project(dvec2 position, ProjectedRay& ray, int index = 0) const;

  const View& view() const { return view_; }

 private:
  View view_;
  CameraKind kind_;
  std::optional<MeshCameraRays> mesh_;  // of kMesh
  double width_, height_;
};

}  // namespace lute
