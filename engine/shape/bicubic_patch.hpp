// bicubic_patch { type T [flatness F] [u_steps U] [v_steps V] [uv_vectors c0 c1 c2 c3,] <16 points> }
//
//   bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3
//     <0,0,0> <1,0,1> <2,0,1> <3,0,0>  <0,1,1> <1,1,2> <2,1,2> <3,1,1>
//     <0,2,1> <1,2,2> <2,2,2> <3,2,1>  <0,3,0> <1,3,1> <2,3,1> <3,3,0> pigment { rgb 1 } }
//
// points: four rows of four; u runs over the rows, v within a row. flatness (default 0): a piece whose control points are all nearer
// than this to a plane through its corners is not divided further; steps (default 0): how often it is halved at most. type 0 and 1
// give the same surface. uv_vectors: texture coordinates of points 1, 4, 16 and 13.
//
// Each piece becomes two triangles between points of the surface; the normal is the surface's own at their corners, blended. The
// pieces are found through a tree of boxes; beyond five halvings they are made anew for every ray, within the hulls of their control
// points, so that memory is bounded (about half a megabyte a patch). A patch has no inside, and clipped_by removes none of its hits.
// Source: specification chapter 21 §5. Halving and hulls: Lane, Riesenfeld: A theoretical development for the computer generation and
// display of piecewise polynomial surfaces (1980); de Casteljau's halving: Farin: Curves and Surfaces for CAGD, chapters 4 and 14.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "engine/shape/shape.hpp"

namespace lute {

struct BicubicPatch {
  static constexpr std::string_view kKeyword = "bicubic_patch";
  double flatness = 0;
  int u_steps = 0, v_steps = 0;
  std::array<dvec2, 4> corner_uv{dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)};
  std::array<std::array<dvec3, 4>, 4> points{};  // [row][column]
};

std::unique_ptr<Shape> build(const BicubicPatch& patch, const Transform& to_world, BuildContext& context);

}  // namespace lute
