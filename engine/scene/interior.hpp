// interior { ... } as the scene file says it. Source: specification chapters 11 §11 and 40 §9.
#pragma once

#include <memory>
#include <vector>

#include "engine/image/color.hpp"
#include "engine/scene/source_location.hpp"

namespace lute {

struct Media;  // engine/scene/media.hpp

struct Interior {
  float ior = 0;  // 0: not given; then 1, and no dispersion
  float dispersion = 1;
  int dispersion_samples = 7;
  float caustics = 0;  // as used: 45 times the written value, or the old finish form unscaled
  float fade_distance = 0, fade_power = 0;
  Rgb fade_color{0.0f};
  float refraction = 1;  // old attenuation factor
  std::vector<std::shared_ptr<const Media>> media;
  SourceLocation where;
};
using InteriorPtr = std::shared_ptr<const Interior>;

}  // namespace lute
