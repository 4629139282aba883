// polygon { count, <p1>, ... }
//
//   polygon { 5, <0, 0>, <2, 0>, <2, 2>, <0, 2>, <0, 0> pigment { rgb 1 } }
//
// At least 3 points in one plane. A point equal to the first of its sub-polygon closes it, the next one opens another; the last is
// closed if need be. Sub-polygons within others are holes: even and odd alternate. Points that are not in one plane are never hit.
// A polygon is a patch: no inside.
// Source: specification chapter 21 §4.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute {

struct Polygon {
  static constexpr std::string_view kKeyword = "polygon";
  std::vector<dvec3> points;
};

// False if the last sub-polygon is open ("Polygon not closed. Closing it.").
bool polygon_is_closed(const Polygon& polygon);

std::unique_ptr<Shape> build(const Polygon& polygon, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
