// What fills the space around the objects: background, sky_sphere, fog, rainbow.
// Source: specification chapters 11 §5 and 40 §12-14.
#pragma once

#include <optional>
#include <vector>

#include "engine/image/color.hpp"
#include "engine/math/transform.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"

namespace lute {

struct SkySphere {
  std::vector<PigmentPtr> pigments;  // from the first written (bottom) to the last (top)
  Transform transform;
  Rgb emission{1.0f};
  SourceLocation where;
};

struct Fog {
  int type = 1;  // 1 constant, 2 ground
  Color color;
  double distance = 0;
  double offset = 0, altitude = 0;  // ground fog
  dvec3 up{0, 1, 0};                // unit
  std::optional<Turbulence> turbulence;
  double turbulence_depth = 0.5;
  SourceLocation where;
};

struct Rainbow {
  double angle = 0, width = 0;      // degrees, as written
  double distance = 1e7;
  double jitter = 0;
  dvec3 direction{0}, up{0, 1, 0};  // as written
  ColorMap colors;
  std::optional<double> arc_angle, falloff_angle;  // degrees, as written
  SourceLocation where;
};

}  // namespace lute
