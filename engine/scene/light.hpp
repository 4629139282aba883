// light_source { ... } as the scene file says it. Source: specification chapters 11 §6.1 and 40 §10.
#pragma once

#include <memory>
#include <optional>

#include "engine/image/color.hpp"
#include "engine/math/vec.hpp"
#include "engine/scene/source_location.hpp"

namespace lute {

struct Object;

enum class LightKind : std::uint8_t { kPoint, kSpot, kCylinder, kShadowless };

struct AreaLight {
  dvec3 axis1{0, 0, 1}, axis2{0, 1, 0};
  int size1 = 1, size2 = 1;
  int adaptive = 100;
  bool jitter = false, circular = false, orient = false;
  bool illumination = false;
};

struct LightSource {
  LightKind kind = LightKind::kPoint;
  bool parallel = false;
  dvec3 location{0};
  dvec3 point_at{0, 0, 1};
  Rgb color{0.0f};
  double radius = 30;   // degrees for spot, units for cylinder
  double falloff = 45;
  double tightness = 0;
  double fade_distance = 0, fade_power = 0;
  std::optional<AreaLight> area;
  bool media_attenuation = false, media_interaction = true;
  std::shared_ptr<const Object> looks_like;          // already at its place
  std::shared_ptr<const Object> projected_through;
  std::optional<bool> photon_refraction, photon_reflection;
  bool photon_area_light = false;
  SourceLocation where;
};

}  // namespace lute
