// Tilings 1 to 24: convex polygons repeated on a lattice of the x-z plane (specification chapter 50 §7).
#pragma once

#include <vector>

#include "engine/math/vec.hpp"

namespace lute {

// A side of a tile: `distance` = offset - dot(outward, point) is positive inside.
struct TileEdge {
  dvec2 outward;  // unit
  double offset;
  double scale;  // the value falls from 1 at the edge to 0 at distance 1 / scale
};

struct Tile {
  std::vector<TileEdge> edges;
  int color_class = 0;   // the values of the tile lie in [color_class, color_class + 1] / classes
  double least = 0;      // keeps flat interiors above the border to the class before
  double raised = 0;     // added to the value
};

struct PolygonTiling {
  int classes = 1;
  dvec2 along[2];           // translations that carry the tiling into itself
  std::vector<Tile> tiles;  // all that touch the parallelogram of the two translations

  double value(dvec2 point) const;
};

const PolygonTiling& polygon_tiling(int number);  // 1...24

}  // namespace lute
