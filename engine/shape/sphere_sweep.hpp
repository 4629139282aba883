// sphere_sweep { linear_spline | cubic_spline | b_spline count, <center>, radius, ... [tolerance t] }
//
//   sphere_sweep { linear_spline 2, <-1, 0, 0>, 0.5, <1, 0, 0>, 0.25 pigment { rgb 1 } }
//
// The space swept by a sphere whose centre and radius follow a spline through (linear, cubic) or near (b_spline) the given ones; at
// least 2, else 4; the first and last of the latter steer only. tolerance (default 1e-6): no hit nearer than this.
//
// Candidates are the whole spheres at the joints, the planes that close each segment, and the envelope of each segment, whose
// parameters are roots of degree 2 or 10. Sorted, they are filtered by counting entries and exits. Inside: the point is on the
// surface of one of a segment's spheres, so a point within all spheres of a short fat segment is outside; authors see that.
// Source: specification chapter 20 §5.14. The envelope's parameters: J. J. van Wijk, Ray Tracing Objects Defined by Sweeping
// a Sphere, 1985; their roots: certified_roots.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute {

struct SphereSweep {
  static constexpr std::string_view kKeyword = "sphere_sweep";
  enum class Spline : std::uint8_t { kLinear, kCubic, kBSpline };
  struct Ball {
    dvec3 center{0};
    double radius = 1;
  };
  Spline spline = Spline::kLinear;
  std::vector<Ball> balls;
  double tolerance = 1e-6;
};

std::unique_ptr<Shape> build(const SphereSweep& sweep, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
