#include "engine/build/built_scene.hpp"

#include <algorithm>
#include <cmath>

#include "engine/build/geometry_answers.hpp"
#include "engine/build/scene_builder.hpp"
#include "engine/build/scene_scale.hpp"
#include "engine/plan/scene_survey.hpp"

namespace lute {
namespace {

ShadingSettings shading_settings(const Scene& scene, const BuildOptions& options) {
  ShadingSettings s;
  s.quality = std::clamp(options.quality, 0, 9);
  s.legacy = scene.effective_version < 370;
  s.output_alpha = options.output_alpha;
  s.adc_bailout = scene.settings.adc_bailout;
  s.max_trace_level = std::clamp(scene.settings.max_trace_level, 1, 256);
  s.ambient_light = scene.settings.ambient_light;
  s.irid_wavelength = scene.settings.irid_wavelength;
  s.noise_generator = scene.settings.noise_generator;
  s.mm_per_unit = scene.settings.mm_per_unit;
  return s;
}

// What a ray sees that meets nothing (chapter 40 §12).
Color built_background(const Scene& scene, const ShadingSettings& settings) {
  if (!scene.background) return {Rgb(0.0f), 0, settings.output_alpha ? 1.0f : 0.0f};
  Color c = *scene.background;
  if (settings.legacy) return {c.rgb, 0, 0};
  if (settings.output_alpha) return c;
  return {c.rgb * (1 - c.transmit), 0, 0};
}

std::unique_ptr<BuiltSky> built_sky(const SkySphere& description, TextureCompiler& textures) {
  auto sky = std::make_unique<BuiltSky>();
  for (const PigmentPtr& pigment : description.pigments) sky->pigments.push_back(textures.pigment(pigment));
  sky->transform = description.transform;
  sky->emission = description.emission;
  return sky;
}

BuiltRainbow built_rainbow(const Rainbow& r, double scale) {
  BuiltRainbow built;
  built.axis = glm::normalize(r.direction);
  built.right = glm::normalize(glm::cross(r.up, built.axis));
  built.up = glm::normalize(glm::cross(built.axis, built.right));
  built.start = radians(r.angle - r.width / 2);
  built.width = radians(r.width);
  built.distance = r.distance * scale;
  built.jitter = r.jitter;
  const double arc = r.arc_angle.value_or(360);
  built.arc = radians(arc) / 2;
  built.falloff = radians(r.falloff_angle.value_or(arc)) / 2;
  built.colors = r.colors.entries;
  return built;
}

void add_surroundings(const Scene& scene, const RenderPlan& plan, BuiltScene& built) {
  built.background = built_background(scene, built.settings);
  if (plan.sky_sphere) built.sky = built_sky(*scene.sky_sphere, *built.textures);
  if (plan.fog) {
    for (const Fog& fog : scene.fogs)
      if (has_effect(fog)) built.fogs.push_back(scaled(fog, built.scale));
  }
  if (plan.rainbow) {
    for (auto rainbow = scene.rainbows.rbegin(); rainbow != scene.rainbows.rend(); ++rainbow)
      if (has_effect(*rainbow)) built.rainbows.push_back(built_rainbow(*rainbow, built.scale));
  }
  built.atmosphere = scene.atmosphere;
}

// What contains the start of the camera's rays is then asked for each of them.
bool rays_start_apart(const Camera& camera) {
  const CameraKind kind = camera.kind;
  return camera.aperture != 0 || kind == CameraKind::kOrthographic || kind == CameraKind::kCylinder3 || kind == CameraKind::kCylinder4 ||
         kind == CameraKind::kMesh;
}

TextureSettings texture_settings(const Scene& scene, const ShadingSettings& settings) {
  TextureSettings result;
  result.noise_generator = scene.settings.noise_generator;
  result.number_of_waves = scene.settings.number_of_waves;
  result.quick_colors = settings.quality < kQualityPatterns;
  result.inside_test = make_inside_test;
  result.addresses_differ = true;
  return result;
}

// Makes the solids. Descriptions go once the scale is certain, for they will not be asked for another one.
void build_solids(double scale, Scene& scene, const RenderPlan& plan, BuiltScene& built) {
  SceneBuilder builder(built, plan.options);
  long solids = 0;
  for (const ObjectPtr& object : scene.objects) solids += builder.count_solids(*object);
  built.solids.reserve(static_cast<std::size_t>(solids));
  builder.use_hierarchy(solids >= plan.options.bounding_threshold);
  builder.keep_containers(plan.interiors);

  SceneSize size;
  std::size_t measured = 0;
  bool certain = scale != 1;
  for (auto object = scene.objects.begin(); object != scene.objects.end(); ++object) {
    builder.add(*object);
    if (certain) {
      object->reset();
      continue;
    }
    for (; measured < built.solids.size(); ++measured) size.add(built.solids[measured]->box(), built.camera);
    certain = stays_ordinary(size);
    if (certain) std::fill(scene.objects.begin(), object + 1, nullptr);
  }
  if (certain) scene.objects = std::vector<ObjectPtr>();
  builder.finish();
}

// `scene` loses its objects if they are certainly not needed again.
std::unique_ptr<BuiltScene> built_at(double scale, Scene& scene, const RenderPlan& plan) {
  auto built = std::make_unique<BuiltScene>();
  built->scale = scale;
  built->camera = scaled(scene.camera, scale);
  built->settings = shading_settings(scene, plan.options);
  built->textures = std::make_unique<TextureCompiler>(texture_settings(scene, built->settings));
  build_solids(scale, scene, plan, *built);
  if (plan.interiors && rays_start_apart(scene.camera)) built->containers.index();
  add_surroundings(scene, plan, *built);
  return built;
}

// Densities of media are per unit of length, in patterns of their own; the meshes of a camera are no solids.
bool keeps_units(const BuiltScene& built) {
  return built.camera.kind == CameraKind::kMesh || !built.atmosphere.empty() ||
         std::ranges::any_of(built.interiors, [](const BuiltInterior& interior) { return !interior.properties->media.empty(); });
}

// Nothing is met farther than 1e7 units away: what stands there is looked for in a smaller picture of the scene.
SceneSize size_of_far(const Scene& scene, const RenderPlan& plan) {
  constexpr double kScale = 0x1p-30;
  Scene copy = scene;
  const auto small = built_at(kScale, copy, plan);
  const SceneSize size = size_of(small->solids, small->camera);
  return {size.reach / kScale, size.smallest / kScale};
}

}  // namespace

void BuiltScene::interiors_at(const dvec3& point, std::vector<const BuiltInterior*>& out) const {
  containers.find(point, out);
}

std::unique_ptr<BuiltScene> build_scene(const Scene& scene, const RenderPlan& plan) {
  Scene copy = scene;
  return build_and_release(copy, plan);
}

std::unique_ptr<BuiltScene> build_and_release(Scene& scene, const RenderPlan& plan) {
  auto built = built_at(1, scene, plan);
  if (!built->solids.empty() && !scene.objects.empty() && !keeps_units(*built)) {
    SceneSize size = size_of(built->solids, built->camera);
    if (size.reach == 0) size = size_of_far(scene, plan);
    const double scale = rendering_scale(size);
    if (scale != 1) built = built_at(scale, scene, plan);
  }
  scene.objects = std::vector<ObjectPtr>();
  return built;
}

}  // namespace lute
