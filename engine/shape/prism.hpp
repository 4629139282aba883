// prism { [linear_sweep | conic_sweep] [linear_spline | quadratic_spline | cubic_spline | bezier_spline]
//         height_1, height_2, count, <x, z>, ... [open] [sturm] }
//
//   prism { linear_sweep linear_spline 0, 1, 4, <-1, -1>, <1, -1>, <0, 1>, <-1, -1> pigment { rgb 1 } }
//
// points: the outline in the xz plane, closed, of one or more sub-curves, each closed where it comes back to its first point;
// quadratic and cubic sub-curves begin (and cubic ones end) with a point that steers only. open: without caps. A conic sweep scales the
// outline by the height: it is as written at y = 1, a point at y = 0.
//
// Sides: one equation in the curve's parameter, of the spline's degree. Where sub-curves overlap, even and odd alternate.
// sturm is accepted and changes nothing: no root is lost without it.
// Source: specification chapter 20 §5.13. The equation of the sides: J. J. van Wijk, Ray Tracing Objects Defined by Sweeping Planar
// Cubic Splines, 1984.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/planar_spline.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

struct Prism {
  static constexpr std::string_view kKeyword = "prism";
  PlanarSpline spline = PlanarSpline::kLinear;
  bool conic = false;
  double height_1 = 0, height_2 = 1;
  std::vector<dvec2> points;  // (x, z)
  bool open = false, sturm = false;
};

// The outline as segments. An outline that is not closed is closed by a line if linear ("Linear prism not closed. Closing it."),
// else it is ignored as a whole: no segments ("Prism not closed. Ignoring it.").
struct PrismOutline {
  std::vector<PlanarSegment> segments;
  bool closed = true;
};
PrismOutline prism_outline(const Prism& prism);

std::unique_ptr<Shape> build(const Prism& prism, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
