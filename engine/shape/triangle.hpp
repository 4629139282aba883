// triangle { <p1>, <p2>, <p3> }
// smooth_triangle { <p1>, <n1>, <p2>, <n2>, <p3>, <n3> }
//
//   triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> pigment { rgb 1 } }
//   smooth_triangle { 0, <-1, 0, -1>, x, <1, 0, -1>, y, <0, 1, -1> pigment { rgb 1 } }
//
// p: corners; n: normals at the corners, of any length; between them the normal is their barycentric mean. A triangle without area
// is never hit; neither is a smooth one whose normals are not all on the same side of it. A triangle is a patch: no inside.
//
// The corners are seen from the ray, sheared so that it runs along one axis; the ray is within if it is on the same side of all three
// edges. Both triangles at a common edge compute the same number for it, so no ray passes between them (Woop, Benthin, Wald:
// Watertight Ray/Triangle Intersection, 2013). Edges and corners belong to the triangle.
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
