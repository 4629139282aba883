#include "parser/dump/dump.hpp"

#include "parser/dump/values.hpp"

namespace lute {

using dump::Json;
using dump::list;
using dump::single;
using dump::to_json;

namespace {

const char* name_of(CameraKind kind) {
  switch (kind) {
    case CameraKind::kPerspective: return "perspective";
    case CameraKind::kOrthographic: return "orthographic";
    case CameraKind::kFisheye: return "fisheye";
    case CameraKind::kUltraWideAngle: return "ultra_wide_angle";
    case CameraKind::kOmnimax: return "omnimax";
    case CameraKind::kPanoramic: return "panoramic";
    case CameraKind::kCylinder1: return "cylinder 1";
    case CameraKind::kCylinder2: return "cylinder 2";
    case CameraKind::kCylinder3: return "cylinder 3";
    case CameraKind::kCylinder4: return "cylinder 4";
    case CameraKind::kSpherical: return "spherical";
    case CameraKind::kMesh: return "mesh_camera";
  }
  return "";
}

Json camera_json(const Camera& c) {
  return {{"kind", name_of(c.kind)}, {"location", to_json(c.location)}, {"direction", to_json(c.direction)}, {"up", to_json(c.up)},
          {"right", to_json(c.right)}, {"sky", to_json(c.sky)}, {"look_at", to_json(c.look_at)}, {"angle", c.angle},
          {"horizontal_angle", c.horizontal_angle}, {"vertical_angle", c.vertical_angle}, {"aperture", c.aperture},
          {"focal_distance", c.focal_distance}, {"blur_samples", {c.blur_samples_min, c.blur_samples_max}},
          {"confidence", c.confidence}, {"variance", c.variance}, {"bokeh", to_json(c.bokeh)}, {"normal", to_json(c.normal)}};
}

const char* name_of(GammaMode mode) {
  switch (mode) {
    case GammaMode::kNone: return "none";
    case GammaMode::kPower: return "power";
    case GammaMode::kSrgb: return "srgb";
  }
  return "";
}

Json settings_json(const GlobalSettings& s) {
  return {{"adc_bailout", single(s.adc_bailout)}, {"ambient_light", to_json(s.ambient_light)},
          {"max_trace_level", s.max_trace_level}, {"noise_generator", s.noise_generator}, {"number_of_waves", s.number_of_waves},
          {"mm_per_unit", s.mm_per_unit}, {"irid_wavelength", to_json(s.irid_wavelength)}, {"gamma_mode", name_of(s.gamma_mode)},
          {"assumed_gamma", s.assumed_gamma}};
}

Json fog_json(const Fog& f) {
  return {{"type", f.type}, {"color", to_json(f.color)}, {"distance", f.distance}, {"offset", f.offset}, {"altitude", f.altitude},
          {"up", to_json(f.up)}, {"turbulence", to_json(f.turbulence)}, {"turbulence_depth", f.turbulence_depth}};
}

Json rainbow_json(const Rainbow& r) {
  return {{"angle", r.angle}, {"width", r.width}, {"distance", r.distance}, {"jitter", r.jitter}, {"direction", to_json(r.direction)},
          {"up", to_json(r.up)}, {"colors", to_json(r.colors)}, {"arc_angle", to_json(r.arc_angle)},
          {"falloff_angle", to_json(r.falloff_angle)}};
}

Json sky_json(const SkySphere& s) {
  return {{"pigments", list(s.pigments)}, {"transform", to_json(s.transform)}, {"emission", to_json(s.emission)}};
}

template <class T, class F>
Json each(const std::vector<T>& values, const F& json_of) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(json_of(value));
  return array;
}

}  // namespace

Json dump_scene(const Scene& scene) {
  return {{"version", scene.version},
          {"effective_version", scene.effective_version},
          {"global_settings", settings_json(scene.settings)},
          {"camera", camera_json(scene.camera)},
          {"background", to_json(scene.background)},
          {"sky_sphere", scene.sky_sphere ? sky_json(*scene.sky_sphere) : Json()},
          {"fogs", each(scene.fogs, fog_json)},
          {"rainbows", each(scene.rainbows, rainbow_json)},
          {"atmosphere", each(scene.atmosphere, [](const auto& media) { return to_json(*media); })},
          {"objects", list(scene.objects)}};
}

}  // namespace lute
