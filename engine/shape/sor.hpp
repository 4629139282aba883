// sor { count, <radius, height>, ... [open] [sturm] }
//
//   sor { 6, <0, -1>, <0.5, 0>, <1, 0.5>, <0.6, 1>, <0.4, 1.6>, <0, 2> pigment { rgb 1 } }
//
// A surface of revolution about the y axis: at least 4 points of ascending height; the first and last steer only. open: without
// the two end discs.
//
// Between two points the squared radius is a cubic of the height, with slopes from the neighbours; x² + z² = r²(y) is then a cubic
// along the ray, set up about the ray's point nearest to the middle of the surface. Inside ignores `open`; the surface is inside.
// uv: u turns about the axis, v runs along the profile (specification chapter 20 §3).
// sturm is accepted and changes nothing: no root is lost without it.
// Source: specification chapter 20 §5.11.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute {

struct Sor {
  static constexpr std::string_view kKeyword = "sor";
  std::vector<dvec2> points;  // (radius, height)
  bool open = false, sturm = false;
};

std::unique_ptr<Shape> build(const Sor& sor, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
