// disc { <center>, <normal>, radius [, hole_radius] }
//
//   disc { <0, 1, 0>, y, 2, 0.5 pigment { rgb <1, 1, 0> } }
//
// radius, hole_radius (default 0): the disc lies between both, edges included. A zero normal or a hole larger than the disc draws
// nothing. The half space behind the disc, whatever its radius, is inside: a disc can clip.
// Source: specification chapter 20 §5.6.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Disc {
  static constexpr std::string_view kKeyword = "disc";
  dvec3 center{0}, normal{0, 1, 0};
  double radius = 1, hole_radius = 0;
};

std::unique_ptr<Shape> build(const Disc& disc, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
