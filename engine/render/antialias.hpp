// Antialiasing: which pixels need more samples, and where those are taken. Source: specification chapter 30 §6.
#pragma once

#include "engine/render/block_grid.hpp"
#include "engine/render/film.hpp"
#include "engine/render/pixel_source.hpp"
#include "engine/scene/scene.hpp"

namespace lute {

struct Antialiasing {
  int method = 0;  // 0: one sample at the centre of a pixel; 1: supersampling where neighbours differ; 2: recursive
  float threshold = 0.3f;  // sum of channel differences from which colours differ, 0...1
  int depth = 3;           // 1...9
  float jitter = 1.0f;     // 0...1; 0: none
  double gamma = 2.5;      // colours are compared after encoding with this power; <= 0 or near 1: as light
};

// Compares colours as an eye would: encoded with the antialiasing gamma, from the scene's working space.
class ColorMetric {
 public:
  ColorMetric(const Antialiasing& settings, GammaMode mode, double assumed_gamma);

  Color encode(const Color& color) const;  // transmit is kept
  // For encoded colours.
  bool differ(const Color& a, const Color& b) const;

 private:
  float threshold_;
  bool decode_srgb_;
  float exponent_;
};

// Renders one block into the film. The film's other pixels are not touched.
void render_block(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric, PixelSource& source,
                  Film& film);

}  // namespace lute
