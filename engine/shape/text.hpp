// text { ttf "font.ttf" | internal n  "string", depth, <offset> }
//
//   text { ttf "timrom.ttf" "lute", 0.25, 0 pigment { rgb <1, 0.8, 0> } }
//
// The characters side by side along x, one em high, from z = 0 to z = depth; offset moves each character on from the one before, in
// x and y. The whole is turned by 0.001 degrees about x, y and z, as the reference does. The scene's parser finds the font file.
//
// Inside an outline: an odd number of crossings toward +x, counted on pieces that only rise or only fall, so that a corner or an extremum
// at the height of the point counts right. Walls: the ray's line and a parabola, a quadratic.
// Source: specification chapter 21 §10.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Text {
  static constexpr std::string_view kKeyword = "text";
  std::shared_ptr<const std::string> font;  // the bytes of a TrueType file
  std::u16string string;
  double depth = 1;
  dvec3 offset{0};
  bool unicode_first = false;  // which of the font's character tables is preferred: charset utf8 or sys
};

// Throws std::runtime_error if the font cannot be read.
std::unique_ptr<Shape> build(const Text& text, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
