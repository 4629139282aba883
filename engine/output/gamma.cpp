#include "engine/output/gamma.hpp"

#include <cmath>

namespace lute {
namespace {

float positive_power(float v, double exponent) { return v > 0 ? std::pow(v, static_cast<float>(exponent)) : 0.0f; }

GammaCurve curve_of(const WorkingSpace& working) {
  return working.mode == GammaMode::kSrgb ? GammaCurve::srgb() : GammaCurve::power(working.assumed_gamma);
}

}  // namespace

GammaCurve GammaCurve::power(double gamma) {
  if (std::abs(1 - 1 / gamma) <= 0.01) return linear();
  return {Kind::kPower, gamma};
}

float GammaCurve::encode(float light) const {
  switch (kind) {
    case Kind::kLinear:
      return light;
    case Kind::kPower:
      return positive_power(light, 1 / gamma);
    case Kind::kSrgb:
      break;
  }
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

float GammaCurve::decode(float number) const {
  switch (kind) {
    case Kind::kLinear:
      return number;
    case Kind::kPower:
      return positive_power(number, gamma);
    case Kind::kSrgb:
      break;
  }
  return number < 0.04045f ? number / 12.92f : std::pow((number + 0.055f) / 1.055f, 2.4f);
}

Transfer::Transfer(const WorkingSpace& working, const GammaCurve& file, const GammaCurve& display)
    : unchanged_(working.mode == GammaMode::kNone),
      working_(unchanged_ ? display : curve_of(working)),
      file_(unchanged_ ? display : file) {
  unchanged_ = unchanged_ || working_ == file_;
}

float Transfer::encode(float value) const {
  if (unchanged_) return value;
  if (working_.kind == GammaCurve::Kind::kPower && file_.kind == GammaCurve::Kind::kPower) {
    return positive_power(value, working_.gamma / file_.gamma);
  }
  return file_.encode(working_.decode(value));
}

float Transfer::decode(float number) const {
  if (unchanged_) return number;
  if (working_.kind == GammaCurve::Kind::kPower && file_.kind == GammaCurve::Kind::kPower) {
    return positive_power(number, file_.gamma / working_.gamma);
  }
  return working_.encode(file_.decode(number));
}

float Transfer::light(float value) const { return working_.decode(value); }

}  // namespace lute
