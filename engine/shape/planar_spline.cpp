#include "engine/shape/planar_spline.hpp"

#include "engine/math/polynomial.hpp"

namespace lute {

Interval PlanarSegment::range(int axis) const { return cubic_value_range(coefficients(axis), {0, 1}); }

PlanarSegment linear_segment(const dvec2& p0, const dvec2& p1) { return {dvec2(0), dvec2(0), p1 - p0, p0}; }

PlanarSegment quadratic_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2) {
  return {dvec2(0), 0.5 * p0 - p1 + 0.5 * p2, 0.5 * (p2 - p0), p1};
}

PlanarSegment cubic_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2, const dvec2& p3) {
  return {0.5 * (3.0 * (p1 - p2) + p3 - p0), p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, 0.5 * (p2 - p0), p1};
}

PlanarSegment bezier_segment(const dvec2& p0, const dvec2& p1, const dvec2& p2, const dvec2& p3) {
  return {p3 - 3.0 * p2 + 3.0 * p1 - p0, 3.0 * p2 - 6.0 * p1 + 3.0 * p0, 3.0 * p1 - 3.0 * p0, p0};
}

std::size_t least_points(PlanarSpline spline) {
  switch (spline) {
    case PlanarSpline::kLinear: return 2;
    case PlanarSpline::kQuadratic: return 3;
    case PlanarSpline::kCubic:
    case PlanarSpline::kBezier: break;
  }
  return 4;
}

}  // namespace lute
