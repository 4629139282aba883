// sphere { <center>, radius }
//
//   sphere { <0, 1, 0>, 1 pigment { rgb <1, 0, 0> } }
//
// center: point; radius: number. A radius of 0 is never hit; a negative one has its normal reversed, so that interior_texture
// shows from outside.
//
// |p - center| = radius. Translated, rotated and uniformly scaled it stays a sphere; any other transformation makes it an
// ellipsoid, the same quadratic in object space. With w = center - origin the ray comes nearest to the centre at b = w·d, at the
// distance |w - b d|; the chord is b ± √(radius² - |w - b d|²), a form that keeps its digits for a distant origin. The surface
// itself is inside of neither the sphere nor its inverse.
// uv: longitude and latitude in the space where the sphere was written.
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

std::unique_ptr<Shape> build(const Sphere& sphere, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
