// material_map { IMAGE ... texture {...} ... }, textures only: the image chooses among textures, which stand at positions 0, 1, 2, ...
// in the texture's map
//
// Value: a whole number, the palette index or 255 · red of the pixel, modulo texture_count (texture_count itself selects the last);
// 0 outside of a `once` image. mapping: how the image lies (engine/texture/image_mapping.hpp).
// Source: specification chapter 50 §11.6.
#pragma once

#include "engine/texture/image_mapping.hpp"
#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct MaterialMap : PatternDefaults {
  static constexpr std::string_view kKeyword = "material_map";
  static constexpr float kFrequency = 0;
  ImageMapping mapping;
  int texture_count = 1;
};

double evaluate(const MaterialMap& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
