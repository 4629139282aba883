#include "engine/texture/pattern/pavement_tiles.hpp"

#include <array>
#include <cassert>
#include <memory>

namespace lute {
namespace {

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

constexpr int kMostTiles = 6, kMostPatterns = 35;

std::size_t table_index(int sides, int tiles, int pattern) {
  return static_cast<std::size_t>(((sides - 3) * (kMostTiles + 1) + tiles) * (kMostPatterns + 1) + pattern);
}

}  // namespace

PavementTiles::PavementTiles(const PavementEntry& entry) : p_(entry.p), r_(entry.r), q_(entry.q) {
  tiles_.resize(2 * static_cast<std::size_t>(p_) * static_cast<std::size_t>(q_));
  int tile = 0;
  for (std::size_t at = 0; at < entry.cells.size();) {
    const char c = entry.cells[at];
    if (c < '0' || c > '9') {
      if (c == '/') ++tile;
      ++at;
      continue;
    }
    const Reduced cell = reduce(c - '0', entry.cells[at + 1] - '0');
    at += 2;
    const bool down = at < entry.cells.size() && entry.cells[at] == 'd';
    if (entry.sides == 3) ++at;
    // Seen from the reduced cell, the listed tile lies so many translates back.
    tiles_[slot(cell, down ? 1 : 0)] = {tile, -cell.along_p, -cell.along_q};
  }
}

PavementTiles::Reduced PavementTiles::reduce(int i, int j) const {
  const int along_q = floor_div(j, q_);
  i -= along_q * r_;
  const int along_p = floor_div(i, p_);
  return {i - along_p * p_, j - along_q * q_, along_p, along_q};
}

std::size_t PavementTiles::slot(const Reduced& cell, int kind) const {
  return 2 * (static_cast<std::size_t>(cell.j) * static_cast<std::size_t>(p_) + static_cast<std::size_t>(cell.i)) +
         static_cast<std::size_t>(kind);
}

TileName PavementTiles::name(int i, int j, int kind) const {
  const Reduced cell = reduce(i, j);
  TileName name = tiles_[slot(cell, kind)];
  name.along_p += cell.along_p;
  name.along_q += cell.along_q;
  return name;
}

const PavementTiles* find_pavement(int sides, int tiles, int pattern) {
  static const std::vector<std::unique_ptr<PavementTiles>> table = [] {
    std::vector<std::unique_ptr<PavementTiles>> all(table_index(6, kMostTiles, kMostPatterns) + 1);
    for (const PavementEntry& entry : kPavements)
      all[table_index(entry.sides, entry.tiles, entry.pattern)] = std::make_unique<PavementTiles>(entry);
    return all;
  }();
  if (sides < 3 || sides > 6 || tiles < 1 || tiles > kMostTiles || pattern < 1 || pattern > kMostPatterns) return nullptr;
  return table[table_index(sides, tiles, pattern)].get();
}

}  // namespace lute
