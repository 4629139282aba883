// torus { major, minor [sturm] }
//
//   torus { 1, 0.25 pigment { rgb <1, 0.5, 0> } }
//
// major: radius of the circle in the xz plane that the tube follows; minor: radius of the tube; sturm is accepted and changes
// nothing. minor = 0 draws nothing; a negative minor with a positive major neither, but has its inside. With minor > major the tube crosses itself; both
// surfaces are seen and the inner lemon is inside. With a negative major, as in POV-Ray, the tube of -major is seen by those rays
// only that meet the smaller ring which the radii as written bound. (POV-Ray with `sturm` also loses the near part of that tube.)
//
// (√(x² + z²) - R)² + y² = r². The ray is first cut down to the stretches within the ring |y| <= r, |√(x² + z²) - R| <= r (at most
// two); on each the quartic is set up about its beginning, with its constant written as a product, so that a tube a million times
// thinner than the ring and an origin a million units away keep their digits. A grazing ray keeps its double root. The surface is
// inside.
// uv: u turns about the y axis, v about the tube (specification chapter 20 §3).
// Source: specification chapter 20 §5.5. The quartic: J. M. Cychosz, Intersecting a Ray with an Elliptical Torus, Graphics Gems II, 1991.
// The cut to the ring and the quartic's constant ((ρ - R)² + y² - r²) ((ρ + R)² + y² - r²), ρ² = x² + z², are own derivations;
// torus_test.cpp has thin tubes and distant origins. Roots: root_walk.hpp.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Torus {
  static constexpr std::string_view kKeyword = "torus";
  double major_radius = 1, minor_radius = 0.25;
  bool sturm = false;
};

std::unique_ptr<Shape> build(const Torus& torus, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
