// image_map { IMAGE ... }, pigments only: the colours of an image
//
// Value: the grey of the colour, 0...1; a pigment takes the colour itself. mapping: how the image lies, transparency: `filter` and
// `transmit` of the statement (both engine/texture/image_mapping.hpp).
// Source: specification chapter 50 §11.
#pragma once

#include "engine/texture/image_mapping.hpp"
#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct ImageMap : PatternDefaults {
  static constexpr std::string_view kKeyword = "image_map";
  static constexpr float kFrequency = 0;
  ImageMapping mapping;
  ImageTransparency transparency;
};

// The grey of the colour; a pigment asks map_color().
double evaluate(const ImageMap& pattern, const dvec3& point, const PatternContext& context);

// False outside a `once` image: the colour is then rgb 1, transmit 1.
bool map_color(const ImageMap& pattern, const dvec3& point, Color& color);

// No point of it lets light through: not a pixel, nor the clear outside of a `once` image.
bool is_opaque(const ImageMap& pattern);

}  // namespace lute
