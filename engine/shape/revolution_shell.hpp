// A quick test for pieces of surfaces of revolution: can a ray meet the space between two radii and two heights?
#pragma once

#include <algorithm>
#include <limits>

#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"

namespace lute {

struct RevolutionShell {
  Interval heights, radii;

  // The whole line is meant, not its positive part. Generous by a relative 1e-9.
  bool meets(const Ray& ray) const {
    const double size = std::max({radii.hi, heights.hi - heights.lo, 1e-300});
    const double slack = 1e-9 * size;
    const dvec3& p = ray.origin;
    const dvec3& d = ray.direction;
    Interval stretch{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    if (d.y != 0) {
      const double t0 = (heights.lo - slack - p.y) / d.y;
      const double t1 = (heights.hi + slack - p.y) / d.y;
      stretch = {std::min(t0, t1), std::max(t0, t1)};
    } else if (p.y < heights.lo - slack || p.y > heights.hi + slack) {
      return false;
    }
    const double a = d.x * d.x + d.z * d.z;
    const double b = p.x * d.x + p.z * d.z;
    const double c = p.x * p.x + p.z * p.z;
    const auto radius2 = [&](double t) { return (a * t + 2 * b) * t + c; };
    const double nearest = a > 0 ? std::clamp(-b / a, stretch.lo, stretch.hi) : 0;
    const double outer = radii.hi + slack;
    if (radius2(nearest) > outer * outer) return false;
    const double inner = std::max(0.0, radii.lo - slack);
    return !(d.y != 0 && std::max(radius2(stretch.lo), radius2(stretch.hi)) < inner * inner);
  }
};

}  // namespace lute
