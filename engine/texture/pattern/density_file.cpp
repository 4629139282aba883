#include "engine/texture/pattern/density_file.hpp"

namespace lute {

double evaluate(const DensityFile& pattern, const dvec3& p, const PatternContext&) {
  using Interpolation = DensityVolume::Interpolation;
  const int kind = pattern.interpolate % 10;
  return pattern.volume->at(p, kind == 0 ? Interpolation::kNone : kind == 1 ? Interpolation::kLinear : Interpolation::kCubic);
}

}  // namespace lute
