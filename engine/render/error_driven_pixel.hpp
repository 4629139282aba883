// Antialiasing method 3, lute's own: a pixel is divided where its samples say that its error comes from, until the
// estimated error is below the chosen bound.
//
// Every pixel begins with the samples at its four corners, which it shares with its neighbours. Where they say that their
// mean may be off by more than the bound, the square of the pixel becomes four cells with one Owen-scrambled Sobol point
// each. The cells whose samples differ most from those beside them, weighted with their area, are divided into four,
// again and again.
#pragma once

#include "engine/render/antialias.hpp"
#include "engine/render/error_map.hpp"

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

  // Corner (x, y) is the top left one of pixel (x, y): one column and one row more than pixels.
  const PixelArea& area() const { return area_; }
  void take(const PixelArea& block, PixelSource& source);  // a part of area()
  Corners of_pixel(int x, int y) const;

 private:
  std::size_t index(int x, int y) const;

  PixelArea area_;
  const DisplayMetric& metric_;
  std::vector<Sample> samples_;
};

// Renders one block of the area. `bound` limits the root mean square error of each pixel, in coded values 0...1.
void render_error_driven_block(const PixelArea& block, double bound, const CornerSamples& corners,
                               const DisplayMetric& metric, PixelSource& source, Film& film, ErrorMap& errors);

}  // namespace lute
