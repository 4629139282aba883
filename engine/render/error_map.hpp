// The estimated error of every pixel: the mean square, over its channels, of what its coded value may be off from the
// mean over the pixel's square.
//
// All estimates come from the samples taken, and assume what pictures are made of: edges. An edge of height h that
// crosses a cell of area A anywhere adds A² h² / 6 on average when the cell has one random sample, A² h² / 12 when it
// has one at the centre or one at each corner. The weights below follow from how often such an edge separates
// neighbouring samples; slopes come out too large by up to 2, noise without structure too small by 2 (in the square).
#pragma once

#include <array>
#include <vector>

#include "engine/render/block_grid.hpp"
#include "engine/render/display_metric.hpp"
#include "engine/render/film.hpp"

namespace lute {

// Times A² and the sum of Δ² over the sides between neighbouring cells, each with one random sample.
constexpr double kSideWeight = 1.0 / 8;
// Times A² and the sum of Δ² over the four sides of a cell with a sample at each corner.
constexpr double kCornerWeight = 1.0 / 24;

class ErrorMap {
 public:
  explicit ErrorMap(const PixelArea& area);

  // Negative where nothing was estimated yet.
  float& at(int x, int y) { return values_[index(x, y)]; }
  float at(int x, int y) const { return values_[index(x, y)]; }

  // Estimates the pixels that have one sample, at their centre, from the pixels around them.
  void estimate_centres(const Film& film, const DisplayMetric& metric);
  // The error of the picture: the root of the mean over all pixels; 0 without pixels.
  double rmse() const;

 private:
  std::size_t index(int x, int y) const;

  PixelArea area_;
  std::vector<float> values_;
};

// The mean square error of the middle one of 3×3 pixels, row by row, with one sample at each centre. Changes that go on
// evenly from pixel to pixel cost nothing: the centre is then their mean.
double centre_error(const std::array<dvec4, 9>& coded, const DisplayMetric& metric);

}  // namespace lute
