// cylinder { <base>, <cap>, radius [open] }
//
// Source: specification chapter 20 §5.3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Cylinder {
  static constexpr std::string_view kKeyword = "cylinder";
  dvec3 base{0}, cap{0, 1, 0};
  double radius = 1;
  bool open = false;
};

std::unique_ptr<Shape> build(const Cylinder& cylinder, const Transform& to_world, BuildContext& context);

}  // namespace lute
