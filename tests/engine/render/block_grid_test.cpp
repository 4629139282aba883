#include "engine/render/block_grid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lute {
namespace {

// Chapter 30 §12 J, a 6x4 image.
PixelArea area(const PartialRender& partial) { return area_of(partial, 6, 4); }

TEST(PartialRender, CountsFromOneAndIncludesTheEnd) {
  EXPECT_EQ(area({.start_column = 3, .start_row = 2, .end_column = 4, .end_row = 3}), (PixelArea{2, 1, 3, 2}));
}

TEST(PartialRender, FractionsAreOfTheImage) {
  EXPECT_EQ(area({.start_column = 0.5, .start_row = 0.25, .end_column = 0.9, .end_row = 0.5}), (PixelArea{3, 1, 4, 1}));
  EXPECT_EQ(area({.end_column = 0.5}), (PixelArea{0, 0, 2, 3}));
}

TEST(PartialRender, OneIsTheWholeImage) {
  EXPECT_EQ(area({.end_column = 1}), (PixelArea{0, 0, 5, 3}));
  EXPECT_EQ(area({.start_column = 1.0}), (PixelArea{0, 0, 5, 3}));
}

TEST(PartialRender, OutsideOfTheImageIsAnError) {
  EXPECT_THROW(area({.start_column = 7}), std::invalid_argument);
  EXPECT_THROW(area({.end_column = 7}), std::invalid_argument);
  EXPECT_THROW(area({.end_column = 0}), std::invalid_argument);
}

TEST(PartialRender, EndBeforeStartIsEmpty) {
  const PixelArea empty = area({.start_column = 5, .end_column = 3});
  EXPECT_EQ(empty.pixels(), 0);
  EXPECT_EQ(BlockGrid(empty, 32).count(), 0);
}

TEST(BlockGrid, CoversTheAreaWithTruncatedBlocksAtTheEnds) {
  const BlockGrid grid({5, 7, 74, 46}, 32);
  ASSERT_EQ(grid.count(), 6);
  EXPECT_EQ(grid.block(0), (PixelArea{5, 7, 36, 38}));
  EXPECT_EQ(grid.block(2), (PixelArea{69, 7, 74, 38}));
  EXPECT_EQ(grid.block(5), (PixelArea{69, 39, 74, 46}));
}

}  // namespace
}  // namespace lute
