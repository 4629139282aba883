// camera { ... } as the scene file says it, after all of its arithmetic (specification chapter 30 §2.3): what remains is type,
// four vectors and the lens.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/math/vec.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"

namespace lute {

enum class CameraKind : std::uint8_t {
  kPerspective, kOrthographic, kFisheye, kUltraWideAngle, kOmnimax, kPanoramic,
  kCylinder1, kCylinder2, kCylinder3, kCylinder4, kSpherical, kMesh
};

struct Camera {
  CameraKind kind = CameraKind::kPerspective;
  dvec3 location{0}, direction{0, 0, 1}, up{0, 1, 0}, right{1.33, 0, 0}, sky{0, 1, 0};
  dvec3 look_at{0, 0, 1};
  double angle = 90;             // degrees; fisheye, ultra_wide_angle, cylinder
  double horizontal_angle = 360, vertical_angle = 180;  // spherical

  double aperture = 0;           // 0: no focal blur
  double focal_distance = 1;
  int blur_samples_min = 0, blur_samples_max = 0;
  double confidence = 0.9, variance = 1e-4;
  PigmentPtr bokeh;              // null: round
  NormalPtr normal;              // null: none
  SourceLocation where;
};

}  // namespace lute
