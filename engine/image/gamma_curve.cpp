#include "engine/image/gamma_curve.hpp"

#include <cmath>

namespace lute {
namespace {

float positive_power(float v, double exponent) { return v > 0 ? std::pow(v, static_cast<float>(exponent)) : 0.0f; }

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

}  // namespace lute
