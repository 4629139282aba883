// Axis-aligned boxes, closed, in world units (where a shape says so, in its own). An unbounded object has infinite sides. No
// operation fails. Source: Kay and Kajiya 1986; the surface area heuristic is Goldsmith's and Salmon's of 1987.
#pragma once

#include <limits>

#include "engine/math/vec.hpp"

namespace lute {

struct Aabb {
  dvec3 lo{std::numeric_limits<double>::infinity()};
  dvec3 hi{-std::numeric_limits<double>::infinity()};  // default: empty, the neutral element of join

  static Aabb infinite();

  bool empty() const;        // no point inside
  bool is_finite() const;    // every side finite
  bool contains(const dvec3& p) const;
  double volume() const;     // 0 when empty
  double half_area() const;  // for the surface area heuristic; 0 when empty
  dvec3 center() const { return 0.5 * (lo + hi); }

  void join(const dvec3& p);
  void join(const Aabb& b);
  Aabb intersection(const Aabb& b) const;
};

}  // namespace lute
