// finish { ... } as the scene file says it, `albedo` already applied.
// Source: specification chapters 11 §9.5 and 40 §6.
#pragma once

#include <memory>
#include <optional>

#include "engine/image/color.hpp"

namespace lute {

struct Finish {
  Rgb ambient{0.1f};
  Rgb emission{0.0f};
  float diffuse = 0.6f;        // scaled by albedo if that was written
  float diffuse_back = 0;
  float raw_diffuse = 0.6f;    // as typed: radiosity and subsurface use these
  float raw_diffuse_back = 0;
  float brilliance = 1;
  float phong = 0, phong_size = 40;
  float specular = 0;
  float specular_exponent = 20;  // 1 / roughness
  float metallic = 0;
  float crand = 0;
  bool conserve_energy = false;

  Rgb reflection_min{0.0f}, reflection_max{0.0f};
  float reflection_falloff = 1;
  float reflection_exponent = 1;  // stored as written^-1
  float reflection_metallic = 0;
  bool reflection_fresnel = false;

  float irid = 0, irid_thickness = 0, irid_turbulence = 0;

  bool subsurface = false;
  Rgb subsurface_translucency{0.0f}, subsurface_anisotropy{0.0f};

  // Old forms, moved to the object's interior when its statement ends.
  std::optional<float> ior, caustics, refraction;

  bool reflects() const { return !(reflection_max == Rgb(0.0f) && reflection_min == Rgb(0.0f)); }
  bool shines() const { return phong > 0 || specular > 0; }
};
using FinishPtr = std::shared_ptr<const Finish>;

}  // namespace lute
