// box { <corner>, <corner> }
//
// Source: specification chapter 20 §5.2.
#pragma once

#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Box {
  static constexpr std::string_view kKeyword = "box";
  dvec3 corner_a{0}, corner_b{1};
};

std::unique_ptr<Shape> build(const Box& box, const Transform& to_world, BuildContext& context);

}  // namespace lute
