// parametric { function { x(u,v) }, function { y(u,v) }, function { z(u,v) } <u0, v0>, <u1, v1> [contained_by {...}] [accuracy a]
//              [max_gradient g] [precompute n, x, y, z] }
//
//   parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) } <0, 0>, <pi, 2*pi>
//     contained_by { sphere { 0, 1.1 } } max_gradient 1.5 pigment { rgb 1 } }
//
// accuracy (default 0.001): size to which a hit is bracketed; the surface appears shifted by about as much along each axis, as the
// reference has it. max_gradient (1): a bound of the functions' slopes. precompute is accepted and changes nothing. A patch: no inside.
//
// Rectangles of u and v are halved while the box of the surface over them, known from the corners and the gradient bound, is met
// by the ray. Source: specification chapter 21 §9. Dividing a patch where the ray meets its bound: T. Whitted, An Improved
// Illumination Model for Shaded Display, 1980; bounds from the slope: B. Von Herzen, A. H. Barr, H. R. Zatz, Geometric Collisions for
// Time-Dependent Parametric Surfaces, 1990.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "engine/shape/container.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

class Function;  // engine/function/function.hpp

struct Parametric {
  static constexpr std::string_view kKeyword = "parametric";
  std::array<std::shared_ptr<const Function>, 3> functions;  // of u and v
  dvec2 lo{0}, hi{1};                                         // of (u, v), sorted
  Container container;
  double accuracy = 0.001, max_gradient = 1;
};

std::unique_ptr<Shape> build(const Parametric& parametric, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
