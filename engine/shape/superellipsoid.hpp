// superellipsoid { <e, n> }
//
//   superellipsoid { <0.25, 0.25> pigment { rgb 1 } }
//
// e, n: how square the sections are seen along z and across; 1, 1 is a sphere, small values make a box with rounded edges, values
// above 2 hollow faces.
//
// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1, evaluated as a nested p-norm minus 1, which neither over- nor underflows. The ray is
// cut at the planes x = ±y, x = ±z, y = ±z, x = 0, y = 0, z = 0: between two cuts the norm is either convex or falls towards the
// ends, so that a change of sign, or a minimum below zero, finds every hit.
// Source: specification chapter 20 §5.9. The surface: A. H. Barr, Superquadrics and Angle-Preserving Transformations, 1981. A p-norm with
// p >= 1 is convex by Minkowski's inequality, and Newton's method from outside approaches a root of a convex function monotonically.
// The cuts for other exponents are an own derivation; that no hit is lost is tested with random rays (tests/engine/shape). Minima:
// golden section, J. Kiefer, Sequential Minimax Search for a Maximum, 1953.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Superellipsoid {
  static constexpr std::string_view kKeyword = "superellipsoid";
  double east_west = 1, north_south = 1;  // e, n
};

std::unique_ptr<Shape> build(const Superellipsoid& shape, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
