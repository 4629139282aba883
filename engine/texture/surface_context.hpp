// What a texture may know of the place that is being shaded.
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

struct SurfaceContext {
  dvec3 point{0};          // in the world
  dvec3 raw_normal{0};     // unit, facing the ray; zero where there is no surface (sky, media, functions)
  dvec3 normal{0};         // the current normal: the raw one, or the last one that a normal pattern left behind
  dvec3 ray_direction{0};  // unit
  dvec2 uv{0};
  bool has_surface = false;
};

}  // namespace lute
