// The samples at the corners of pixels, with which antialiasing method 3 begins.
//
// Every pixel shares its four corners with its neighbours. Every other corner is traced, as the black squares of a chequer;
// the others are traced where the four around them differ, and otherwise are their mean. A few of the black ones stand aside of
// the grid: a pattern that repeats from pixel to pixel would look even on any grid.
#pragma once

#include <array>
#include <vector>

#include "engine/render/block_grid.hpp"
#include "engine/render/display_metric.hpp"
#include "engine/render/pixel_source.hpp"

namespace lute {

// The samples at the corners of an area of pixels.
class CornerSamples {
 public:
  struct Sample {
    Color color;
    glm::vec4 coded;
  };
  // Top left, top right, bottom left, bottom right.
  using Corners = std::array<const Sample*, 4>;

  CornerSamples(const PixelArea& area, const DisplayMetric& metric);

  // Corner (x, y) is the top left one of pixel (x, y). The corners of the pixels and a ring around them, so that a part
  // of the picture does not depend on where it ends; black ones in two rings more.
  const PixelArea& area() const { return area_; }
  const PixelArea& area_of_black() const { return area_of_black_; }

  void trace_black(const PixelArea& block, PixelSource& source);  // a part of area_of_black()
  // A part of area(), after all of the black ones. `bound`: on the error of a pixel.
  void fill_white(const PixelArea& block, double bound, PixelSource& source);

  Corners of_pixel(int x, int y) const;
  // The mean square error of the mean of the pixel's corners, or more than `allowed`.
  double error_of_pixel(int x, int y, double allowed) const;

 private:
  std::size_t index(int x, int y) const;
  void trace(int x, int y, PixelSource& source);
  double difference(int x, int y, const dvec4& from) const;  // mean square
  double contrast_farther(int x, int y, const dvec4& mean) const;
  double contrast_across(int x, int y, double least) const;
  bool interpolate(int x, int y, double bound);  // false: the corners around differ

  PixelArea area_, area_of_black_;
  const DisplayMetric& metric_;
  std::vector<Sample> samples_;
};

}  // namespace lute
