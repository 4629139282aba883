// Antialiasing: which pixels need more samples, and where those are taken. Source: specification chapter 30 §6.
#pragma once

#include "engine/render/block_grid.hpp"
#include "engine/render/error_map.hpp"
#include "engine/render/film.hpp"
#include "engine/render/pixel_source.hpp"
#include "engine/scene/scene.hpp"

namespace lute {

struct Antialiasing {
  // 0: one sample at the centre of a pixel; 1: supersampling where neighbours differ; 2: recursive; 3: driven by the
  // estimated error (engine/render/error_driven_pixel.hpp), which uses none of the following but the last
  int method = 0;
  float threshold = 0.3f;  // sum of channel differences from which colours differ, 0...1
  int depth = 3;           // 1...9
  float jitter = 1.0f;     // 0...1; 0: none
  double gamma = 2.5;      // colours are compared after encoding with this power; <= 0 or near 1: as light
  double error_bound = 0.01;  // of method 3: largest estimated error of a pixel, root mean square of coded 0...1

  bool error_driven() const { return method == 3; }
  bool moves_samples() const { return (method == 1 || method == 2) && jitter != 0; }
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

// Where the estimated errors of pixels with many samples go.
struct ErrorRecord {
  const DisplayMetric& metric;
  ErrorMap& map;
};

// Renders one block into the film, by method 0, 1 or 2. The film's other pixels are not touched. `errors` may be null.
void render_block(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric, PixelSource& source,
                  Film& film, const ErrorRecord* errors = nullptr);

}  // namespace lute
