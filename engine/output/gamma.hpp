// Gamma: the way of a rendered colour into a file.
//
// All in single precision, as the reference computes. Source: specification chapter 30 §7.1, §7.3.
#pragma once

#include "engine/image/gamma_curve.hpp"
#include "engine/scene/scene.hpp"

namespace lute {

// The numbers of a scene: which curve its colours are in, and whether gamma is handled at all.
struct WorkingSpace {
  GammaMode mode = GammaMode::kPower;
  double assumed_gamma = 1;
};

// From working space to file and back. Where both curves are the same, or gamma is not handled, values pass unchanged.
class Transfer {
 public:
  Transfer(const WorkingSpace& working, const GammaCurve& file, const GammaCurve& display);

  float encode(float value) const;   // working space -> file
  float decode(float number) const;  // file -> working space
  float light(float value) const;    // working space -> linear light, for EXR and HDR
  // What the file says about itself (gAMA, sRGB): the display's curve where gamma is not handled.
  const GammaCurve& declared() const { return file_; }

 private:
  bool unchanged_;
  GammaCurve working_, file_;
};

}  // namespace lute
