// The part of the image that is rendered, and its division into square blocks, the units of work.
//
// A block is computed from (scene, settings, block index) alone. Antialiasing by method 1 sees the block borders, so
// the size of the blocks is part of the picture. Source: specification chapter 30 §8.
#pragma once

namespace lute {

// Columns and rows, both ends included; empty when last < first.
struct PixelArea {
  int first_column = 0, first_row = 0, last_column = -1, last_row = -1;

  int columns() const { return last_column < first_column ? 0 : last_column - first_column + 1; }
  int rows() const { return last_row < first_row ? 0 : last_row - first_row + 1; }
  long pixels() const { return static_cast<long>(columns()) * rows(); }
  bool operator==(const PixelArea&) const = default;
};

// Start_Column, Start_Row, End_Column, End_Row as given: fractions of the image or pixels counted from 1 (a start below
// 1, an end of up to 1 is a fraction).
struct PartialRender {
  double start_column = 1, start_row = 1;
  double end_column = 1, end_row = 1;
};

// Throws std::invalid_argument for a start or end outside of the image.
PixelArea area_of(const PartialRender& partial, int width, int height);

class BlockGrid {
 public:
  BlockGrid(const PixelArea& area, int block_size);  // block_size >= 1

  int count() const { return across_ * down_; }
  PixelArea block(int index) const;  // row by row from the top left

 private:
  PixelArea area_;
  int size_;
  int across_ = 0, down_ = 0;
};

}  // namespace lute
