// The box or sphere that an isosurface or a parametric surface is looked for in: `contained_by { box {...} | sphere {...} }`.
// Source: specification chapter 21 §8.1, §8.5.
#pragma once

#include <cstdint>

#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"
#include "engine/math/transform.hpp"

namespace lute {

struct Container {
  bool is_sphere = false;
  dvec3 lo{-1}, hi{1};  // of a box, sorted
  dvec3 center{0};      // of a sphere
  double radius = 1;      // its sign tells of the normal alone

  Aabb box() const;
  bool contains(const dvec3& p) const;

  // The passage of a ray, and where it enters and leaves: faces 2 * axis + (1 at the upper corner), or kRound.
  static constexpr std::uint32_t kRound = 6;
  struct Passage {
    Interval depths;
    std::uint32_t enter = kRound, leave = kRound;
  };
  // The whole line; the direction need not be of unit length. False as well where the depths are not finite.
  bool cross(const Ray& ray, Passage& passage) const;

  // The reference misses its own surface where the radius is negative, and shades a closed end like the surface in it.
  bool has_normal(std::uint32_t face) const { return face != kRound || radius >= 0; }
  dvec3 normal(std::uint32_t face, const dvec3& p) const;  // outward
};

// An accuracy that is a length along the ray in world units, as the reference has it. Where it is not small beside the container, as after
// scaling a shape down to 1e-6, it counts in the shape's own units.
double depth_accuracy(double accuracy, const Container& container, const Transform& to_world);

}  // namespace lute
