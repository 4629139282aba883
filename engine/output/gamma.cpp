#include "engine/output/gamma.hpp"

namespace lute {
namespace {

GammaCurve curve_of(const WorkingSpace& working) {
  return working.mode == GammaMode::kSrgb ? GammaCurve::srgb() : GammaCurve::power(working.assumed_gamma);
}

}  // namespace

Transfer::Transfer(const WorkingSpace& working, const GammaCurve& file, const GammaCurve& display)
    : unchanged_(working.mode == GammaMode::kNone),
      working_(unchanged_ ? display : curve_of(working)),
      file_(unchanged_ ? display : file) {
  unchanged_ = unchanged_ || working_ == file_;
}

float Transfer::encode(float value) const {
  if (unchanged_) return value;
  if (working_.kind == GammaCurve::Kind::kPower && file_.kind == GammaCurve::Kind::kPower) {
    return GammaCurve{GammaCurve::Kind::kPower, working_.gamma / file_.gamma}.decode(value);
  }
  return file_.encode(working_.decode(value));
}

float Transfer::decode(float number) const {
  if (unchanged_) return number;
  if (working_.kind == GammaCurve::Kind::kPower && file_.kind == GammaCurve::Kind::kPower) {
    return GammaCurve{GammaCurve::Kind::kPower, file_.gamma / working_.gamma}.decode(number);
  }
  return working_.encode(file_.decode(number));
}

float Transfer::light(float value) const { return working_.decode(value); }

}  // namespace lute
