// A scene ready to be rendered: everything in world space, textures and lights compiled, interiors shared as the language says,
// solids in an acceleration structure. Never changed once built; threads share it.
// Source: specification chapters 11 §14, 20 §6-8 and 40.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "engine/accel/scene_tree.hpp"
#include "engine/build/containers.hpp"
#include "engine/csg/solid.hpp"
#include "engine/light/light.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/scene/scene.hpp"
#include "engine/texture/texture_compiler.hpp"

namespace lute {

struct InteriorProperties {
  float ior = 1;  // an interior without ior has 1
  float dispersion = 1;
  int dispersion_samples = 7;
  float caustics = 0;  // exponent; 0: no faked caustics
  float fade_distance = 0, fade_power = 0;
  Rgb fade_color{0.0f};
  float refraction = 1;  // old attenuation factor
  std::vector<std::shared_ptr<const Media>> media;
  SourceLocation where;
};

// What a ray travels through inside an object. Its address is its identity: a ray's list of interiors compares addresses.
struct BuiltInterior {
  Shared<InteriorProperties> properties;
  bool hollow = false;
};

struct BuiltSky {
  std::vector<const CompiledPigment*> pigments;  // from the bottom to the top
  Transform transform;                           // a direction is taken through its inverse, translation included
  Rgb emission{1.0f};
};

struct BuiltRainbow {
  dvec3 axis{0}, right{0}, up{0};  // unit; axis: toward the centre of the bow
  double start = 0, width = 0;     // radians from the axis
  double distance = 0, jitter = 0;
  double arc = 0, falloff = 0;     // half angles, radians
  std::vector<ColorMap::Entry> colors;
};

struct LightGroup {
  std::vector<const BuiltLight*> lights;
};

struct ShadingSettings {
  int quality = 9;
  bool legacy = false;         // effective version below 3.7
  bool output_alpha = false;
  float adc_bailout = 1.0f / 255.0f;
  int max_trace_level = 5;     // 1...256
  Rgb ambient_light{1.0f};
  Rgb irid_wavelength{0.70f, 0.52f, 0.48f};
  int noise_generator = 2;
  double mm_per_unit = 10;
};

struct BuiltScene {
  double scale = 1;  // of all lengths, against the scene's own units (engine/build/scene_scale.hpp)
  Camera camera;     // at its place in the built scene
  ShadingSettings settings;
  std::unique_ptr<TextureCompiler> textures;           // owns every compiled texture
  std::deque<BuiltInterior> interiors;
  std::vector<std::unique_ptr<Solid>> solids;          // top level, in scene order
  std::unique_ptr<SceneTree> tree;
  std::vector<std::unique_ptr<BuiltLight>> lights;     // of groups too
  std::vector<const BuiltLight*> global_lights;        // in scene order
  std::vector<LightGroup> light_groups;                // Leaf::light_group is an index
  Color background{Rgb(0.0f), 0, 1};
  std::unique_ptr<BuiltSky> sky;                       // null: none
  std::vector<Fog> fogs;                               // those with effect; none where the plan has none
  std::vector<BuiltRainbow> rainbows;                  // the same, last declared first
  std::vector<std::shared_ptr<const Media>> atmosphere;

  // Interiors of the solids that contain a point, in scene order: where a camera ray starts (chapter 20 §8.1).
  void interiors_at(const dvec3& point, std::vector<const BuiltInterior*>& out) const;

  // The isosurfaces and where they stand in the scene's text, for gradient_remark (engine/shape/gradient_remark.hpp).
  struct PlacedShape {
    const Shape* shape;
    SourceLocation where;
  };
  std::vector<PlacedShape> isosurfaces;

  Containers containers;  // top-level solids with an inside
};

// `plan` is the one made of this scene: what it leaves out is not built.
std::unique_ptr<BuiltScene> build_scene(const Scene& scene, const RenderPlan& plan);

// The same, and gives back the memory of the objects' descriptions on the way: `scene` has none any more afterwards.
std::unique_ptr<BuiltScene> build_and_release(Scene& scene, const RenderPlan& plan);

}  // namespace lute
