// triangle { <p1>, <p2>, <p3> }
// smooth_triangle { <p1>, <n1>, <p2>, <n2>, <p3>, <n3> }
//
// Source: specification chapter 21 §2.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct Triangle {
  static constexpr std::string_view kKeyword = "triangle";
  std::array<dvec3, 3> vertices{};
};

struct SmoothTriangle {
  static constexpr std::string_view kKeyword = "smooth_triangle";
  std::array<dvec3, 3> vertices{};
  std::array<dvec3, 3> normals{};  // as written, any length
};

std::unique_ptr<Shape> build(const Triangle& triangle, const Transform& to_world, BuildContext& context);
std::unique_ptr<Shape> build(const SmoothTriangle& triangle, const Transform& to_world, BuildContext& context);

}  // namespace lute
