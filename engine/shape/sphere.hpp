// sphere { <center>, radius }
//
//   sphere { <0, 1, 0>, 1 pigment { rgb <1, 0, 0> } }
//
// |p - center| = radius. Translated, rotated and uniformly scaled it stays a sphere; any other transformation makes it an
// ellipsoid, the same quadratic in object space. A radius of 0 is never hit; a negative one has its normal reversed.
// Source: specification chapter 20 §5.1; uv from chapter 20 §3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Sphere {
  static constexpr std::string_view kKeyword = "sphere";
  dvec3 center{0};
  double radius = 1;
};

std::unique_ptr<Shape> build(const Sphere& sphere, const Transform& to_world, BuildContext& context);

}  // namespace lute
