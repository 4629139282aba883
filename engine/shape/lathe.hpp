// lathe { [linear_spline | quadratic_spline | cubic_spline | bezier_spline] count, <x, y>, ... [sturm] }
//
//   lathe { cubic_spline 4, <0.5, -2>, <0.5, -1>, <1, 0>, <0.25, 1> pigment { rgb 1 } }
//
// points: the profile, (radius, height), turned about the y axis; at least 2, 3, 4 points, for bezier_spline groups of 4. The first
// and last points of the quadratic and cubic kinds steer the curve only. Ends are not capped.
//
// With the profile (X(w), Y(w)) a hit satisfies |ray at height Y(w)|² = X(w)²: degree 2, 4 or 6 in w, set up about the ray's point
// nearest to the lathe's middle. Inside: an odd number of profile crossings outward of the point, within the profile's overall
// range of heights and radii.
// uv: u turns about the axis, v runs along the profile (specification chapter 20 §3).
// sturm is accepted and changes nothing: no root is lost without it.
// Source: specification chapter 20 §5.12. The equation in w: J. J. van Wijk, Ray Tracing Objects Defined by Sweeping Planar Cubic
// Splines, 1984. Setting it up in the lathe's middle, and the depth of flat rays from the radius, are own derivations, tested with random rays. Roots:
// root_walk.hpp.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/planar_spline.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

struct Lathe {
  static constexpr std::string_view kKeyword = "lathe";
  PlanarSpline spline = PlanarSpline::kLinear;
  std::vector<dvec2> points;
  bool sturm = false;
};

std::unique_ptr<Shape> build(const Lathe& lathe, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
