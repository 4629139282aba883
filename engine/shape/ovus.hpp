// ovus { bottom_radius, top_radius [sturm] }
//
//   ovus { 1, 0.5 pigment { rgb <1, 0.9, 0.8> } }
//
// An egg: a sphere of bottom_radius about the origin, one of top_radius about <0, bottom_radius, 0>, and a piece of a spindle torus
// that joins them smoothly. Radii are not negative. With top_radius >= 2 bottom_radius it is the sphere at the top alone.
// sturm is accepted and changes nothing: no root is lost without it.
// Source: specification chapter 20 §5.15; uv from chapter 20 §3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Ovus {
  static constexpr std::string_view kKeyword = "ovus";
  double bottom_radius = 1, top_radius = 0.5;
  bool sturm = false;
};

std::unique_ptr<Shape> build(const Ovus& ovus, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
