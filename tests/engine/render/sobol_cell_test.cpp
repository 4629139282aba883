#include "engine/render/sobol_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lute {
namespace {

TEST(SobolCells, PointLiesInItsCell) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SobolCells points(seed);
    for (int level = 0; level <= SobolCells::kDeepestLevel; ++level) {
      const int side = 1 << level;
      for (int cell = 0; cell < side * side; ++cell) {
        const dvec2 at = points.point(level, cell % side, cell / side);
        ASSERT_EQ(static_cast<int>(std::floor(at.x * side)), cell % side) << "level " << level << " seed " << seed;
        ASSERT_EQ(static_cast<int>(std::floor(at.y * side)), cell / side) << "level " << level << " seed " << seed;
      }
    }
  }
}

TEST(SobolCells, PointOfACellIsThatOfOneOfItsParts) {
  const SobolCells points(7);
  for (int level = 0; level < SobolCells::kDeepestLevel; ++level) {
    for (int cell = 0; cell < 1 << (2 * level); ++cell) {
      const int column = cell & ((1 << level) - 1), row = cell >> level;
      const dvec2 whole = points.point(level, column, row);
      int found = 0;
      for (int part = 0; part < 4; ++part) {
        found += points.point(level + 1, 2 * column + (part & 1), 2 * row + (part >> 1)) == whole ? 1 : 0;
      }
      ASSERT_EQ(found, 1) << "level " << level << " cell " << cell;
    }
  }
}

// Sobol 1967: the points of a level form a (0, m, 2)-net, one in each of the 2^m boxes of every elementary shape.
TEST(SobolCells, PointsOfALevelAreANetInBoxesOfEveryShape) {
  const SobolCells points(123);
  constexpr int kLevel = 4, kSide = 1 << kLevel, kBits = 2 * kLevel;
  for (int bits_x = 0; bits_x <= kBits; ++bits_x) {
    std::set<std::pair<int, int>> boxes;
    for (int cell = 0; cell < kSide * kSide; ++cell) {
      const dvec2 at = points.point(kLevel, cell % kSide, cell / kSide);
      boxes.insert({static_cast<int>(at.x * (1 << bits_x)), static_cast<int>(at.y * (1 << (kBits - bits_x)))});
    }
    EXPECT_EQ(boxes.size(), 1u << kBits) << bits_x << " bits of x";
  }
}

// A scrambled point is uniform: over seeds, its mean is 1/2 and its variance 1/12.
TEST(SobolCells, PointIsUniformOverSeeds) {
  dvec2 sum(0), squares(0);
  constexpr int kSeeds = 20000;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const dvec2 at = SobolCells(seed).point(0, 0, 0);
    sum += at;
    squares += at * at;
  }
  for (int i = 0; i < 2; ++i) {
    const double mean = sum[i] / kSeeds;
    EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1.0 / 12 / kSeeds));
    EXPECT_NEAR(squares[i] / kSeeds - mean * mean, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / kSeeds));
  }
}

}  // namespace
}  // namespace lute
