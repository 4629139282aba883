#include "engine/render/display_metric.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

DisplayMetric::DisplayMetric(GammaMode mode, double assumed_gamma, bool alpha)
    : unchanged_(mode != GammaMode::kPower),
      working_(GammaCurve::power(assumed_gamma)),
      weight_(alpha ? dvec4(0.25) : dvec4(1.0 / 3, 1.0 / 3, 1.0 / 3, 0)) {
  for (std::size_t i = 0; i < coded_.size(); ++i) {
    const float root = static_cast<float>(i) / kSteps, value = root * root;
    coded_[i] = exactly_coded(value);
    // The secant over two steps of an 8-bit file, since curves are steep at black and end at white.
    constexpr float kStep = 1.0f / 256;
    const float slope = (exactly_coded(value + kStep) - exactly_coded(value - kStep)) / (2 * kStep);
    slope2_[i] = slope * slope;
  }
}

float DisplayMetric::exactly_coded(float value) const {
  const float seen = unchanged_ ? value : GammaCurve::srgb().encode(working_.decode(value));
  return seen > 0 ? std::min(seen, 1.0f) : 0.0f;
}

// A value that is not a number is black, as in files.
float DisplayMetric::at_root_of(float value, const Table& table) {
  if (!(value > 0)) return table.front();
  const float place = std::min(std::sqrt(value), 1.0f) * kSteps;
  const auto below = static_cast<std::size_t>(place);
  return std::lerp(table[below], table[below + 1], place - static_cast<float>(below));
}

dvec4 DisplayMetric::coded(const Color& color) const {
  return {at_root_of(color.rgb.r, coded_), at_root_of(color.rgb.g, coded_), at_root_of(color.rgb.b, coded_),
          std::clamp(color.transmit, 0.0f, 1.0f)};
}

double DisplayMetric::mean_square(const dvec4& difference) const { return glm::dot(weight_, difference * difference); }

dvec4 DisplayMetric::sensitivity(const Color& color) const {
  const auto slope2 = [this](float value) { return value > 1 + 1.0f / 256 ? 0.0f : at_root_of(value, slope2_); };
  return weight_ * dvec4(slope2(color.rgb.r), slope2(color.rgb.g), slope2(color.rgb.b), 1);
}

}  // namespace lute
