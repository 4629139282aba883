// How a scene with assumed_gamma 1 has the colours of an image file read.
#pragma once

#include "engine/image/image_file.hpp"

namespace lute {

inline ImageFileOptions colors_in_linear_space() {
  ImageFileOptions options;
  options.for_colors = true;
  options.working = GammaCurve::linear();
  return options;
}

}  // namespace lute
