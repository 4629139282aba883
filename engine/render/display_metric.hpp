// Colours and errors as they are seen: channels coded as in an sRGB file, clamped to 0...1. What lies above white or
// below black costs no samples.
//
// Curves are tables over the square root of the value, which follows them closely: an estimate needs no more than their
// six digits, and asks for them at every sample.
#pragma once

#include <array>

#include "engine/image/color.hpp"
#include "engine/image/gamma_curve.hpp"
#include "engine/math/vec.hpp"
#include "engine/scene/scene.hpp"

namespace lute {

// Red, green, blue, transmit.
inline dvec4 channels(const Color& c) { return {c.rgb.r, c.rgb.g, c.rgb.b, c.transmit}; }

class DisplayMetric {
 public:
  // The working space of the colours; `alpha`: transparency is seen, too.
  DisplayMetric(GammaMode mode, double assumed_gamma, bool alpha);

  dvec4 coded(const Color& color) const;
  // The mean square over the channels that are seen, of a difference of coded colours.
  double mean_square(const dvec4& difference) const;
  // Channel by channel: the mean square coded error per variance in the working space, for a pixel of this colour.
  dvec4 sensitivity(const Color& color) const;

 private:
  static constexpr int kSteps = 1024;
  using Table = std::array<float, kSteps + 2>;  // of root 0 ... 1, and once more for interpolation

  float exactly_coded(float value) const;
  static float at_root_of(float value, const Table& table);

  bool unchanged_;
  GammaCurve working_;
  dvec4 weight_;  // of each channel in a mean square
  Table coded_, slope2_;
};

}  // namespace lute
