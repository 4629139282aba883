// A light source ready to shade with, in world space. Source: specification chapter 40 §7, §10.
//
// One file for each kind of light: spot.cpp, cylinder.cpp, parallel.cpp, area.cpp; the point, and what they share, is here.
#pragma once

#include <memory>
#include <optional>

#include "engine/csg/solid.hpp"
#include "engine/scene/light.hpp"

namespace lute {

// One end of the light's path: a sample of an area light, or the location of any other.
struct LightPath {
  dvec3 direction{0};   // unit, from the lit point to the light
  double distance = 0;  // world units; to the plane through the light if parallel, and negative behind it
};

struct BuiltLight {
  LightKind kind = LightKind::kPoint;
  bool parallel = false;
  dvec3 location{0}, point_at{0, 0, 1};
  dvec3 axis{0, 0, 1};  // unit, from location to point_at; transformations renormalise it
  Rgb color{0.0f};
  double radius = 0, falloff = 0, tightness = 0;  // as written: degrees for spot, world units for cylinder
  double cos_radius = 0, cos_falloff = 0;         // spot
  double fade_distance = 0, fade_power = 0;
  bool fades = false;
  std::optional<AreaLight> area;  // at its place; null where quality asks for a point
  double axis1_length = 0, axis2_length = 0;
  bool media_attenuation = false, media_interaction = true;
  std::unique_ptr<Solid> projected_through;  // null: none
  SourceLocation where;
  std::size_t number = 0;  // among the lights of the scene

  bool attenuates() const { return fades || kind == LightKind::kSpot || kind == LightKind::kCylinder; }  // by angle or distance
  bool casts_shadows() const { return kind != LightKind::kShadowless; }
  bool has_highlights() const { return kind != LightKind::kShadowless; }
};

// Fills what is derived from the description; `to_world` moves location, point_at, axis and the axes of an area light.
BuiltLight build_light(const LightSource& description, const Transform& to_world, bool area_lights);

// A light that shines the same in all directions.
inline LightPath point_path(const dvec3& sample, const dvec3& point) {
  const dvec3 to_light = sample - point;
  const double distance = glm::length(to_light);
  return {distance > 0 ? to_light / distance : to_light, distance};
}

LightPath path_of_kind(const BuiltLight& light, const dvec3& sample, const dvec3& point);

// L and d of §10.2 toward `sample`, a point of the light (its location, or a point of its area).
inline LightPath path_to(const BuiltLight& light, const dvec3& sample, const dvec3& point) {
  return light.parallel || light.kind == LightKind::kCylinder ? path_of_kind(light, sample, point) : point_path(sample, point);
}

// The factor of §10.3 for angle and distance; 0 outside the cone.
double attenuation(const BuiltLight& light, const dvec3& point, const LightPath& path);

}  // namespace lute
