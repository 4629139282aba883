// cylinder { <base>, <cap>, radius [open] }
//
//   cylinder { <0, 0, 0>, <0, 2, 0>, 0.5 open pigment { rgb 1 } }
//
// base, cap: centres of the two ends, which must differ; radius: its sign is ignored, 0 draws nothing; open: without end discs.
//
// x² + y² = 1 for 0 <= z <= 1 in a frame of its own. Where side and end disc are hit at the same depth, the disc is reported. The
// surface of a closed cylinder is outside, that of an open one inside.
// Source: specification chapter 20 §5.3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Cylinder {
  static constexpr std::string_view kKeyword = "cylinder";
  dvec3 base{0}, cap{0, 1, 0};
  double radius = 1;
  bool open = false;
};

std::unique_ptr<Shape> build(const Cylinder& cylinder, const Transform& to_world, BuildContext& context);

}  // namespace lute
