// mesh_camera { rays distribution [reach] mesh ... [smooth] }: rays that leave from the faces of meshes, along their normals.
//
// Image positions are those of engine/camera/projection.hpp. Which face a position belongs to is the distribution:
//   0  ray n leaves from face row * width + column of mesh n
//   1  the faces of all meshes in one row; only ray 0 meets one
//   2  the meshes side by side in the image
//   3  where the position lies in the uv map of the first mesh
// Source: specification chapter 30 §3.2, with its oddities: the first two rows of an image show the same faces.
#pragma once

#include <optional>
#include <vector>

#include "engine/accel/triangle_tree.hpp"
#include "engine/camera/projected_ray.hpp"
#include "engine/scene/camera.hpp"

namespace lute {

class MeshCameraRays {
 public:
  // `camera.mesh` must be there.
  MeshCameraRays(const Camera& camera, int width, int height);

  int rays_per_position() const { return description_->rays; }

  // The ray `index` of a position; false: there is none.
  bool project(dvec2 position, int index, ProjectedRay& ray) const;

 private:
  // A place on a face: the mesh, the face, barycentric weights of its corners.
  struct Spot {
    std::size_t mesh = 0, face = 0;
    std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
  };

  std::optional<Spot> spot(dvec2 cell, int index) const;
  std::optional<Spot> in_row(std::size_t number) const;
  std::optional<Spot> side_by_side(dvec2 cell) const;
  std::optional<Spot> on_uv_map(dvec2 cell) const;
  dvec3 normal(const Spot& spot) const;

  std::shared_ptr<const MeshCamera> description_;
  std::optional<TriangleTree> uv_tree_;  // of distribution 3: the uv map as a flat mesh in the plane z = 0
  double width_, height_;
  double offset_;   // from the face, along its normal
  bool backwards_;
};

}  // namespace lute
