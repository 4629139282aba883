#include "engine/render/sobol_cell.hpp"

#include <array>
#include <cassert>

namespace lute {
namespace {

constexpr int kBits = 32;

constexpr std::uint32_t reversed(std::uint32_t v) {
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
  v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
  return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

// The second dimension of the sequence; the first is the reversed index.
constexpr std::uint32_t sobol_y(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
    if (index & 1) result ^= direction;
  }
  return result;
}

// The same with its bits reversed.
constexpr std::uint32_t reversed_sobol_y(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1; index != 0; index >>= 1, direction ^= direction << 1) {
    if (index & 1) result ^= direction;
  }
  return result;
}

// The bits of numbers of kDeepestLevel bits reversed.
constexpr auto kReversedPrefix = [] {
  std::array<std::uint8_t, 1 << SobolCells::kDeepestLevel> table{};
  for (std::uint32_t v = 0; v < table.size(); ++v) {
    table[v] = static_cast<std::uint8_t>(reversed(v) >> (kBits - SobolCells::kDeepestLevel));
  }
  return table;
}();

constexpr std::uint32_t reversed_prefix(std::uint32_t prefix, int level) {
  return static_cast<std::uint32_t>(kReversedPrefix[prefix]) >> (SobolCells::kDeepestLevel - level);
}

// The cells of all lower levels.
constexpr std::size_t cells_below(int level) { return ((std::size_t{1} << (2 * level)) - 1) / 3; }

// Which of the first 4^level points lies in a cell of the unscrambled sequence, level after level.
class CellIndex {
 public:
  constexpr CellIndex() {
    for (int level = 0; level <= SobolCells::kDeepestLevel; ++level) {
      for (std::uint32_t index = 0; index < 1u << (2 * level); ++index) {
        const std::uint32_t x = prefix(reversed(index), level), y = prefix(sobol_y(index), level);
        indices_[place(level, x, y)] = static_cast<std::uint16_t>(index);
      }
    }
  }

  constexpr std::uint32_t of(int level, std::uint32_t x, std::uint32_t y) const { return indices_[place(level, x, y)]; }

 private:
  static constexpr std::uint32_t prefix(std::uint32_t v, int level) { return level == 0 ? 0 : v >> (kBits - level); }
  static constexpr std::size_t place(int level, std::uint32_t x, std::uint32_t y) {
    return cells_below(level) + (static_cast<std::size_t>(y) << level) + x;
  }

  std::array<std::uint16_t, cells_below(SobolCells::kDeepestLevel + 1)> indices_{};
};

constexpr CellIndex kCellIndex;

// A permutation in which every bit depends on the lower ones only: on reversed numbers, a nested scrambling.
std::uint32_t permuted(std::uint32_t v, std::uint32_t seed) {
  v += seed;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return v;
}

// Of the number whose bits are those of `v` reversed.
std::uint32_t scrambled(std::uint32_t v, std::uint32_t seed) { return reversed(permuted(v, seed)); }

// The first `level` bits that are scrambled to the first `level` bits `prefix`, bit after bit.
std::uint32_t unscrambled_prefix(std::uint32_t prefix, int level, std::uint32_t seed) {
  if (level == 0) return 0;
  const std::uint32_t wanted = reversed_prefix(prefix, level);
  std::uint32_t bits = 0;
  for (int bit = 0; bit < level; ++bit) bits ^= (permuted(bits, seed) ^ wanted) & (1u << bit);
  return reversed_prefix(bits, level);
}

std::uint64_t mixed(std::uint64_t z) {  // splitmix64
  z += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

SobolCells::SobolCells(std::uint64_t seed) {
  const std::uint64_t bits = mixed(seed);
  seed_x_ = static_cast<std::uint32_t>(bits);
  seed_y_ = static_cast<std::uint32_t>(bits >> 32);
}

dvec2 SobolCells::point(int level, int column, int row) const {
  assert(level >= 0 && level <= kDeepestLevel);
  const std::uint32_t index =
      kCellIndex.of(level, unscrambled_prefix(static_cast<std::uint32_t>(column), level, seed_x_),
                    unscrambled_prefix(static_cast<std::uint32_t>(row), level, seed_y_));
  return {scrambled(index, seed_x_) * 0x1p-32, scrambled(reversed_sobol_y(index), seed_y_) * 0x1p-32};
}

}  // namespace lute
