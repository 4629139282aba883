// The runtime form of `cone` and `cylinder`: x² + y² = (1 + taper z)² for 0 <= z <= 1 in a frame of its own, with or without its two
// discs. Source: specification chapter 20 §5.3.
//
// Unlike the usual x² + y² = z² this form stays exact when a cone is nearly a cylinder: no apex runs off to infinity.
#pragma once

#include <memory>

#include "engine/shape/shape.hpp"

namespace lute {

// `frame` carries the canonical shape into the world. taper = (radius at z = 1) / (radius at z = 0) - 1, at least -2: below -1
// both radii have opposite signs and the two halves meet in a point. `axis_normal`: the normal of the disc at z = 1 as it is shown, of
// the length of frame.normal({0, 0, 1}).
std::unique_ptr<Shape> build_truncated_cone(const Transform& frame, const dvec3& axis_normal, double taper, bool open);

}  // namespace lute
