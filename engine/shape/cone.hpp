// cone { <base>, base_radius, <cap>, cap_radius [open] }
//
//   cone { <0, 0, 0>, 1, <0, 2, 0>, 0 pigment { rgb <0, 1, 0> } }
//
// base, cap: centres of the two ends, which must differ; the radii are used with their signs: radii of opposite sign make two cones
// that meet in a point; open: without end discs. With equal radii it is a cylinder, and with two negative ones too: of the radius nearer
// to zero, as the reference has it.
//
// The radius changes linearly from end to end. Where side and end disc are hit at the same depth, the disc is reported. The surface
// of a closed cone is outside, that of an open one inside.
// Source: specification chapter 20 §5.3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Cone {
  static constexpr std::string_view kKeyword = "cone";
  dvec3 base{0}, cap{0, 1, 0};
  double base_radius = 1, cap_radius = 0;
  bool open = false;
};

std::unique_ptr<Shape> build(const Cone& cone, const Transform& to_world, BuildContext& context);

}  // namespace lute
