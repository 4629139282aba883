// Curves in a plane made of cubic segments: the profile of a lathe, the outline of a prism.
// Source: specification chapter 20 §5.12-5.13.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/interval.hpp"
#include "engine/math/vec.hpp"

namespace lute {

enum class PlanarSpline : std::uint8_t { kLinear, kQuadratic, kCubic, kBezier };

// ((a w + b) w + c) w + d for w in [0, 1].
struct PlanarSegment {
  dvec2 a{0}, b{0}, c{0}, d{0};

  dvec2 at(double w) const { return ((a * w + b) * w + c) * w + d; }
  dvec2 tangent(double w) const { return (3.0 * a * w + 2.0 * b) * w + c; }
  // Coefficients of one coordinate, ascending.
  std::array<double, 4> coefficients(int axis) const { return {d[axis], c[axis], b[axis], a[axis]}; }
  // Range of one coordinate over the segment, exact.
  Interval range(int axis) const;
};

PlanarSegment linear_segment(const dvec2& p0, const dvec2& p1);
PlanarSegment quadratic_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2);                // from p1 to p2
PlanarSegment cubic_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2, const dvec2& p3);   // from p1 to p2
PlanarSegment bezier_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2, const dvec2& p3);  // from p0 to p3

// Number of points that a curve of this kind needs at least.
std::size_t least_points(PlanarSpline spline);

}  // namespace lute
