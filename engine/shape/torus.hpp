// torus { major, minor }
//
// Source: specification chapter 20 §5.5.
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

std::unique_ptr<Shape> build(const Torus& torus, const Transform& to_world, BuildContext& context);

}  // namespace lute
