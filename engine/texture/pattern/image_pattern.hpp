// image_pattern { IMAGE once map_type interpolate use_alpha ... }: an image as a pattern
//
// Value: 0...1, clamped: the grey of the image; with use_alpha its transparency, or red where it has none. 0 outside of a `once`
// image. Not processed by frequency, phase and wave. mapping: how the image lies (engine/texture/image_mapping.hpp).
// Source: specification chapter 50 §11.5.
#pragma once

#include "engine/texture/image_mapping.hpp"
#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct ImagePattern : PatternDefaults {
  static constexpr std::string_view kKeyword = "image_pattern";
  static constexpr float kFrequency = 0;
  ImageMapping mapping;
  bool use_alpha = false;
};

double evaluate(const ImagePattern& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
