// Which tile of a pavement a cell belongs to (specification chapter 50 §8).
#pragma once

#include <vector>

#include "engine/texture/pattern/pavement_table.hpp"

namespace lute {

// Names one tile of the plane: its place in the list and the translate.
struct TileName {
  int tile = -1, along_p = 0, along_q = 0;
  friend bool operator==(const TileName&, const TileName&) = default;
};

class PavementTiles {
 public:
  explicit PavementTiles(const PavementEntry& entry);

  TileName square(int i, int j) const { return name(i, j, 0); }
  TileName hexagon(int i, int j) const { return name(i, j, 0); }
  TileName triangle(int i, int j, bool up) const { return name(i, j, up ? 0 : 1); }

 private:
  struct Reduced {
    int i, j, along_p, along_q;
  };
  Reduced reduce(int i, int j) const;
  std::size_t slot(const Reduced& cell, int kind) const;
  TileName name(int i, int j, int kind) const;

  int p_, r_, q_;
  std::vector<TileName> tiles_;  // of the cells 0 <= i < p, 0 <= j < q, two kinds each
};

// Null if there is no such pavement.
const PavementTiles* find_pavement(int sides, int tiles, int pattern);

}  // namespace lute
