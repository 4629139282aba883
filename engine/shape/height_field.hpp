// height_field { IMAGE [water_level w] [smooth] }
//
//   height_field { png "mountains.png" smooth water_level 0.2 translate -0.5 scale <10, 1, 10> }
//
// A landscape over the unit square of x and z, with heights of up to 1: the bottom row of the image lies at z = 0. water_level (default
// 0): what lies below is cut away; smooth: normals are interpolated.
//
// Every cell between four pixels is two triangles. The ray goes from square to square of a pyramid of
// least and greatest heights (A. Tevs, I. Ihrke, H.-P. Seidel, Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field
// Rendering, 2008).
// Smooth normals are kept as 16-bit integers, and those of steep ground are coarse: authors see it.
// Inside: below the ground, without limit downward.
// Source: specification chapter 21 §6.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute {

// Heights at integer x (column) and z, 0 to 65535; z = 0 is the bottom row of the image.
struct HeightGrid {
  int width = 0, depth = 0;
  std::vector<std::uint16_t> heights;  // [z * width + x]

  int at(int x, int z) const { return heights[static_cast<std::size_t>(z) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

struct HeightField {
  static constexpr std::string_view kKeyword = "height_field";
  std::shared_ptr<const HeightGrid> grid;  // at least 2 by 2
  double water_level = 0;                  // 0 to 1
  bool smooth = false;
};

std::unique_ptr<Shape> build(const HeightField& field, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
