// Antialiasing method 3, lute's own: a pixel is divided where its samples say that its error comes from, until the
// estimated error is below the chosen bound.
//
// Every pixel has a sample at its centre. Where the pixels around it say that this one may be off by more than the
// bound, the square of the pixel becomes four cells with one Owen-scrambled Sobol point each. The cells whose samples
// differ most from those beside them, weighted with their area, are divided into four, again and again.
#pragma once

#include "engine/render/antialias.hpp"
#include "engine/render/error_map.hpp"

namespace lute {

// The samples at the centres of an area of pixels and of the ring around it.
class CentreSamples {
 public:
  CentreSamples(const PixelArea& area, const DisplayMetric& metric);

  const PixelArea& with_ring() const { return ring_; }
  void take(const PixelArea& block, PixelSource& source);  // a part of with_ring()

  const Color& color(int x, int y) const { return samples_[index(x, y)].color; }
  // 3×3 pixels around (x, y), row by row; (x, y) is not of the ring.
  std::array<dvec4, 9> coded_around(int x, int y) const;
  std::array<dvec4, 9> channels_around(int x, int y) const;

 private:
  struct Sample {
    Color color;
    glm::vec4 coded;
  };
  std::size_t index(int x, int y) const;

  PixelArea ring_;
  const DisplayMetric& metric_;
  std::vector<Sample> samples_;
};

// Renders one block of the area. `bound` limits the root mean square error of each pixel, in coded values 0...1.
void render_error_driven_block(const PixelArea& block, double bound, const CentreSamples& centres,
                               const DisplayMetric& metric, PixelSource& source, Film& film, ErrorMap& errors);

}  // namespace lute
