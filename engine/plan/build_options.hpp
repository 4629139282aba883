// What the options say about the picture as a whole, and from which quality on (+Q) a feature is rendered.
// Source: specification chapter 40 §15.
#pragma once

namespace lute {

constexpr int kQualityLights = 2;        // below: pigments without light
constexpr int kQualityShadows = 4;
constexpr int kQualityAreaLights = 5;    // below: points
constexpr int kQualityPatterns = 6;      // below: quick_color, where one is given
constexpr int kQualityTransmission = 6;
constexpr int kQualityReflection = 8;    // normal patterns too
constexpr int kQualityVolumes = 9;       // fog and rainbow

struct BuildOptions {
  int quality = 9;
  bool output_alpha = false;
  int bounding_threshold = 3;
  bool remove_bounds = true;
  bool split_unions = false;
};

}  // namespace lute
