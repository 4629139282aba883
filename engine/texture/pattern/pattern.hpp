// What all patterns share. A pattern maps a point of pattern space to a value.
//
// To add a pattern, write `engine/texture/pattern/<name>.{hpp,cpp}` with
//   * a plain struct derived from PatternDefaults, its parameters as the scene file says them, with `kKeyword`;
//   * `double evaluate(const Name&, const dvec3& point, const PatternContext&)`;
// and its line in `engine/texture/pattern/table.hpp`. A pattern without parameters needs no parser code: the parser finds its
// keyword through the table.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/image/color.hpp"
#include "engine/math/vec.hpp"

namespace lute {

enum class Wave : std::uint8_t { kRamp, kTriangle, kSine, kScallop, kCubic, kPoly };

struct PatternDefaults {
  static constexpr float kFrequency = 1;  // 0: no wave or frequency processing
  static constexpr Wave kWave = Wave::kRamp;
  static constexpr int kListLength = 0;  // checker 2, hexagon 3, ...: how many items a list of colours, pigments, ... has
};

// What a pattern may look at besides the point.
struct PatternContext {
  int noise_generator = 2;  // 1, 2 or 3, already resolved
  // The surface being shaded, for slope and aoi; normal is zero where there is no surface (sky, media, functions).
  dvec3 normal{0};         // current perturbed normal
  dvec3 ray_direction{0};  // unit, toward the surface
  dvec2 uv{0};
};

}  // namespace lute
