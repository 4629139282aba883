// A scene, complete, as the file says it: plain values that the parser fills and the engine builds from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/atmosphere.hpp"
#include "engine/scene/camera.hpp"
#include "engine/scene/object.hpp"

namespace lute {

// How the numbers of a scene relate to light (specification chapter 30 §7.1).
enum class GammaMode : std::uint8_t {
  kNone,   // no gamma handling: values are written as they are
  kPower,  // working space is a power curve; 1 is linear
  kSrgb
};

struct GlobalSettings {
  float adc_bailout = 1.0f / 255.0f;
  Rgb ambient_light{1.0f};
  int max_trace_level = 5;
  int noise_generator = 2;
  int number_of_waves = 10;
  double mm_per_unit = 10;
  Rgb irid_wavelength{0.70f, 0.52f, 0.48f};
  GammaMode gamma_mode = GammaMode::kPower;
  double assumed_gamma = 1;
};

struct Scene {
  std::vector<std::string> files;  // names as messages show them; SourceLocation::file is an index
  int version = 370;               // `#version` times 100, raised to at least 350
  int effective_version = 370;     // the same, but 362 when the scene never states one
  GlobalSettings settings;
  Camera camera;
  std::optional<Color> background;  // as written; what alpha output makes of it is decided when the scene is built
  SourceLocation background_where;
  std::optional<SkySphere> sky_sphere;
  std::vector<Fog> fogs;
  std::vector<Rainbow> rainbows;
  std::vector<std::shared_ptr<const Media>> atmosphere;
  std::vector<ObjectPtr> objects;   // top level, in scene order, lights included
};

}  // namespace lute
