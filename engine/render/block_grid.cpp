#include "engine/render/block_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lute {
namespace {

int first_of(double start, int size) {
  return start >= 0 && start < 1 ? static_cast<int>(std::floor(size * start)) : static_cast<int>(start) - 1;
}

int last_of(double end, int size) {
  return (end >= 0 && end <= 1 ? static_cast<int>(std::floor(size * end)) : static_cast<int>(end)) - 1;
}

}  // namespace

PixelArea area_of(const PartialRender& partial, int width, int height) {
  // Far larger than any image, and still an int.
  const auto bounded = [](double value) { return std::clamp(value, -1e9, 1e9); };
  const PixelArea area{first_of(bounded(partial.start_column), width), first_of(bounded(partial.start_row), height),
                       last_of(bounded(partial.end_column), width), last_of(bounded(partial.end_row), height)};
  const auto outside = [](int index, int size) { return index < 0 || index >= size; };
  if (outside(area.first_column, width) || outside(area.first_row, height)) {
    throw std::invalid_argument("invalid start column or row: it lies outside of the image");
  }
  if (outside(area.last_column, width) || outside(area.last_row, height)) {
    throw std::invalid_argument("invalid end column or row: it lies outside of the image");
  }
  return area;
}

BlockGrid::BlockGrid(const PixelArea& area, int block_size)
    : area_(area), size_(std::max(1, std::min(block_size, std::max(area.columns(), area.rows())))) {
  across_ = (area.columns() + size_ - 1) / size_;
  down_ = (area.rows() + size_ - 1) / size_;
}

PixelArea BlockGrid::block(int index) const {
  const int left = area_.first_column + index % across_ * size_;
  const int top = area_.first_row + index / across_ * size_;
  return {left, top, std::min(left + size_ - 1, area_.last_column), std::min(top + size_ - 1, area_.last_row)};
}

}  // namespace lute
