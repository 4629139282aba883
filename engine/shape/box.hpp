// box { <corner>, <corner> }
//
//   box { <-1, 0, -1>, <1, 2, 1> pigment { rgb <0, 0, 1> } }
//
// Two opposite corners in any order. A flat box is drawn as a rectangle; the face that the ray leaves by is the one reported.
//
// The ray meets the slab between each pair of faces in an interval; the box is met where the three overlap. On an edge, where two
// faces are met within a millionth of each other, the face whose axis has the larger share of the direction is reported, x before y
// before z among equals. The surface is inside. Scaled and translated it stays along the axes, otherwise it keeps its matrix.
// uv: the faces unfolded as a cross (specification chapter 20 §3) whose corners are sorted once more by every scale written before the
// first rotation or matrix: a negative factor there does not mirror the map, one behind it does (found with POV-Ray).
// Source: specification chapter 20 §5.2. Slabs: T. L. Kay, J. T. Kajiya, Ray Tracing Complex Scenes, 1986.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Box {
  static constexpr std::string_view kKeyword = "box";
  dvec3 corner_a{0}, corner_b{1};
};

std::unique_ptr<Shape> build(const Box& box, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
