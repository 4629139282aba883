// One pixel under division into cells, with one Owen-scrambled Sobol point in each.
//
// The error of a cell follows from how much its sample differs from those beside it: edges between cells that differ. That fails
// for what is finer than the cells, where neighbours are alike by chance. Samples of an edge differ along a line, which is at most
// about two sides of the pixel long; where they differ over a greater length, there is a pattern. Its variance, as far as samples
// beside each other are no more alike than others, counts for every cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/render/corner_samples.hpp"
#include "engine/render/display_metric.hpp"
#include "engine/render/pixel_source.hpp"
#include "engine/render/sobol_cell.hpp"

namespace lute {

// Kept for the pixels of a block, so that its memory is.
class DividedPixel {
 public:
  static constexpr int kDeepest = 5;  // 32 × 32 cells

  // `bound` limits the root mean square error of the pixel, in coded values 0...1.
  DividedPixel(const DisplayMetric& metric, PixelSource& source, double bound)
      : metric_(metric), source_(source), allowed_(bound * bound) {}

  // The mean of pixel (x, y), divided into 4^first_level cells at least; first_level is 1 or 2.
  Color render(int x, int y, const CornerSamples::Corners& corners, int first_level);

  // Of the last one: its mean square error, the number of its cells, and the variance of the pattern in it, coded; 0: none seen.
  double error() const { return error_; }
  int cells() const { return static_cast<int>(cells_.size()); }
  double pattern() const { return pattern_; }

 private:
  static constexpr int kSide = 1 << kDeepest;  // of the smallest cells in a pixel

  struct Cell {
    int level, column, row;
    dvec2 at;  // the sample, in the pixel's square
    Color color;
    double error = 0;  // its share of the pixel's mean square error

    int size() const { return kSide >> level; }  // in smallest cells
    double area() const { return 1.0 / static_cast<double>(1 << (2 * level)); }
  };
  // Over the sides between cells, each counted twice: lengths, squared differences times length, the greatest one.
  struct Sides {
    double length = 0, squares = 0, greatest = 0;
  };
  // Which cell covers each of the smallest ones.
  using CellMap = std::array<std::uint16_t, kSide * kSide>;

  Cell sampled(const SobolCells& points, int level, int column, int row);
  void paint(std::size_t number);
  Color mean() const;
  Color mean_with(const CornerSamples::Corners& corners);
  void estimate();
  double unresolved(const Sides& sides, const dvec4& sensitivity);
  double contrast(const Cell& cell, const dvec4& sensitivity, Sides& sides) const;
  bool divide_worst(const SobolCells& points);
  void divide(const SobolCells& points, std::size_t number);
  const Cell& cell_at(int x, int y) const { return cells_[owner_[static_cast<std::size_t>(y * kSide + x)]]; }

  const DisplayMetric& metric_;
  PixelSource& source_;
  double allowed_;
  double left_ = 0, top_ = 0;
  std::array<dvec4, 4> corners_{};
  std::vector<Cell> cells_;
  CellMap owner_{};
  std::vector<std::size_t> order_;
  double error_ = 0, pattern_ = 0;
};

}  // namespace lute
