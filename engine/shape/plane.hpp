// plane { <normal>, distance }
//
// Source: specification chapter 20 §5.4.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Plane {
  static constexpr std::string_view kKeyword = "plane";
  dvec3 normal{0, 1, 0};
  double distance = 0;
};

std::unique_ptr<Shape> build(const Plane& plane, const Transform& to_world, BuildContext& context);

}  // namespace lute
