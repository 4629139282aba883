// cone { <base>, base_radius, <cap>, cap_radius [open] }
//
// Source: specification chapter 20 §5.3.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Cone {
  static constexpr std::string_view kKeyword = "cone";
  dvec3 base{0}, cap{0, 1, 0};
  double base_radius = 1, cap_radius = 0;
  bool open = false;
};

std::unique_ptr<Shape> build(const Cone& cone, const Transform& to_world, BuildContext& context);

}  // namespace lute
