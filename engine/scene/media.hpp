// media { ... } as the scene file says it. Source: specification chapters 11 §5.4 and 60 §3.
#pragma once

#include <vector>

#include "engine/image/color.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"

namespace lute {

struct Media {
  int method = 3;
  int intervals = 1;
  int samples_min = 10, samples_max = 10;
  double confidence = 0.9, variance = 1.0 / 128.0, ratio = 0.9;
  int aa_level = 3;
  double aa_threshold = 0.1, jitter = 0;
  Rgb absorption{0.0f}, emission{0.0f};
  int scattering_type = 1;
  Rgb scattering{0.0f};
  double eccentricity = 0, extinction = 1;
  bool collect = true;
  std::vector<PigmentPtr> densities;  // their values multiply
  SourceLocation where;
};

}  // namespace lute
