// disc { <center>, <normal>, radius [, hole_radius] }
//
// Source: specification chapter 20 §5.6.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Disc {
  static constexpr std::string_view kKeyword = "disc";
  dvec3 center{0}, normal{0, 1, 0};
  double radius = 1, hole_radius = 0;
};

std::unique_ptr<Shape> build(const Disc& disc, const Transform& to_world, BuildContext& context);

}  // namespace lute
