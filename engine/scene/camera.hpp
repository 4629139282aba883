// camera { ... } as the scene file says it, after all of its arithmetic (specification chapter 30 §2.3): what remains is type,
// four vectors and the lens.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/math/vec.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"
#include "engine/shape/mesh.hpp"

namespace lute {

enum class CameraKind : std::uint8_t {
  kPerspective, kOrthographic, kFisheye, kUltraWideAngle, kOmnimax, kPanoramic,
  kCylinder1, kCylinder2, kCylinder3, kCylinder4, kSpherical, kMesh
};

// What mesh_camera { ... } says (engine/camera/mesh_camera.hpp).
struct MeshCamera {
  enum class Distribution : std::uint8_t { kMeshOfRay, kAllInARow, kSideBySide, kUvMap };
  struct Part {
    std::shared_ptr<const MeshData> data;
    Transform transform;
  };
  int rays = 1;      // of a position; their mean counts
  Distribution distribution = Distribution::kMeshOfRay;
  double reach = 0;  // hits from this distance on do not count; 0: all do
  bool smooth = false;
  std::vector<Part> parts;  // at least one; kMeshOfRay: at least one for each ray
};

struct Camera {
  CameraKind kind = CameraKind::kPerspective;
  dvec3 location{0}, direction{0, 0, 1}, up{0, 1, 0}, right{1.33, 0, 0}, sky{0, 1, 0};
  dvec3 look_at{0, 0, 1};
  double angle = 90;             // degrees; fisheye, ultra_wide_angle, cylinder
  double horizontal_angle = 360, vertical_angle = 180;  // spherical

  std::shared_ptr<const MeshCamera> mesh;  // of kMesh only: there location.z and direction.z are offset and sign along normals

  double aperture = 0;           // 0: no focal blur
  double focal_distance = 1;
  int blur_samples_min = 0, blur_samples_max = 0;
  double confidence = 0.9, variance = 1e-4;
  PigmentPtr bokeh;              // null: round
  NormalPtr normal;              // null: none
  SourceLocation where;
};

}  // namespace lute
