#include "engine/render/display_metric.hpp"

#include <algorithm>

namespace lute {

DisplayMetric::DisplayMetric(GammaMode mode, double assumed_gamma, bool alpha)
    : unchanged_(mode != GammaMode::kPower),
      working_(GammaCurve::power(assumed_gamma)),
      weight_(alpha ? dvec4(0.25) : dvec4(1.0 / 3, 1.0 / 3, 1.0 / 3, 0)) {}

float DisplayMetric::coded(float value) const {
  const float seen = unchanged_ ? value : GammaCurve::srgb().encode(working_.decode(value));
  return seen > 0 ? std::min(seen, 1.0f) : 0.0f;  // a value that is not a number is black, as in files
}

dvec4 DisplayMetric::coded(const Color& color) const {
  return {coded(color.rgb.r), coded(color.rgb.g), coded(color.rgb.b), std::clamp(color.transmit, 0.0f, 1.0f)};
}

double DisplayMetric::mean_square(const dvec4& difference) const { return glm::dot(weight_, difference * difference); }

dvec4 DisplayMetric::sensitivity(const Color& color) const {
  // The secant over two steps of an 8-bit file, since curves are steep at black and end at white.
  constexpr float kStep = 1.0f / 256;
  const auto slope = [this](float value) -> double {
    return (coded(value + kStep) - coded(value - kStep)) / (2 * kStep);
  };
  const dvec4 slopes(slope(color.rgb.r), slope(color.rgb.g), slope(color.rgb.b), 1);
  return weight_ * slopes * slopes;
}

}  // namespace lute
