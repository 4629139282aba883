// quadric { <A, B, C>, <D, E, F>, <G, H, I>, J }
//
//   quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 clipped_by { plane { y, 2 } } pigment { rgb 1 } }
//
// A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0. Points with a negative or zero value are inside, the surface
// included. `inverse` does not change the raw normal: it is negated in the coefficients and again by the mark.
//
// The ray's quadratic is set up about the ray's point nearest to the centre of the transformed surface's origin and solved without
// cancellation. Only ellipsoids have finite bounds of their own.
// Source: specification chapter 20 §5.7.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Quadric {
  static constexpr std::string_view kKeyword = "quadric";
  dvec3 squares{0};  // A, B, C
  dvec3 mixed{0};    // D, E, F: of xy, xz, yz
  dvec3 linear{0};   // G, H, I
  double constant = 0;
};

std::unique_ptr<Shape> build(const Quadric& quadric, const Transform& to_world, BuildContext& context);

}  // namespace lute
