// plane { <normal>, distance }
//
//   plane { y, 0 pigment { checker rgb 1, rgb 0 } }
//
// normal: vector, of any length but zero; distance: from the origin to the plane along the unit normal.
//
// N·p = distance with the unit normal N; the half space against the normal is inside. Points within 1e-10 of the plane are inside
// of both the plane and its inverse. Depths up to 1e7 are seen: the horizon.
// Source: specification chapter 20 §5.4.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Plane {
  static constexpr std::string_view kKeyword = "plane";
  dvec3 normal{0, 1, 0};
  double distance = 0;
};

std::unique_ptr<Shape> build(const Plane& plane, const Transform& to_world, BuildContext& context);

}  // namespace lute
