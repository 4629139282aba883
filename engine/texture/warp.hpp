// Warps: what moves a point before a pattern sees it. A chain of them is applied from first to last (specification chapter 50 §5).
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "engine/math/rounding.hpp"
#include "engine/math/transform.hpp"
#include "engine/math/vec.hpp"

namespace lute {

struct Turbulence {
  dvec3 amount{0};
  int octaves = 6;  // 1...10
  float omega = 0.5f;
  float lambda = 2.0f;
};

struct ClassicTurbulence : Turbulence {};  // plain `turbulence`: always the last element of its chain
struct TurbulenceWarp : Turbulence {};
struct RepeatWarp {
  int axis = 0;  // 0, 1, 2
  float width = 1;
  dvec3 flip{1};  // +1 or -1 each
  dvec3 offset{0};
};
struct BlackHoleWarp {
  dvec3 center{0};
  double radius = 1;
  double strength = 1, falloff = 2;
  bool inverse = false;
  int type = 0;
  std::optional<dvec3> repeat;
  dvec3 turbulence{0};
};
struct PlanarWarp { dvec3 orientation{0, 0, 1}; double offset = 0; };
struct CylindricalWarp { dvec3 orientation{0, 0, 1}; double dist_exp = 0; };
struct SphericalWarp { dvec3 orientation{0, 0, 1}; double dist_exp = 0; };
struct ToroidalWarp { dvec3 orientation{0, 0, 1}; double dist_exp = 0; double major_radius = 1; };
struct CubicWarp {};

// A Transform is applied by its inverse.
using Warp = std::variant<Transform, ClassicTurbulence, TurbulenceWarp, RepeatWarp, BlackHoleWarp, PlanarWarp, CylindricalWarp,
                          SphericalWarp, ToroidalWarp, CubicWarp>;
using WarpChain = std::vector<Warp>;

// The point with each coordinate kept within 1e17, and never not a number: what patterns are asked for.
inline dvec3 bounded_coordinates(const dvec3& point) {
  constexpr double kLimit = 1e17;
  return {bounded(point.x, kLimit), bounded(point.y, kLimit), bounded(point.z, kLimit)};
}

// The point after the chain, whatever numbers that gives. Classic turbulence is left out where the pattern uses it itself.
dvec3 apply_warps(const WarpChain& chain, dvec3 point, bool skip_classic_turbulence);

// The turn of (x, z) around the y axis as a fraction of the circle, from +x toward +z.
double turn_about_y(double x, double z);
// The turn of a point around the ring of radius `major_radius` in the x-z plane as a fraction of the circle, and its distance from
// the ring.
struct RingPosition {
  double turn, distance;
};
RingPosition turn_about_ring(const dvec3& p, double major_radius);

// A transformation written after the chain: composed into the first element if that is a transformation, else put in front.
void prepend_transform(WarpChain& chain, const Transform& transform);

}  // namespace lute
