// density_file df3 "name" { interpolate n }: a volume of densities that fills the unit cube
//
// Value: 0...1, where cubic interpolation may overshoot 1; 0 outside of the cube. interpolate (default 0): none, 1 trilinear, else
// tricubic; only n mod 10 counts. The volume is read, and its errors are reported, by engine/image/density_volume.hpp.
// Source: specification chapter 50 §6.5.
#pragma once

#include <memory>

#include "engine/image/density_volume.hpp"
#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct DensityFile : PatternDefaults {
  static constexpr std::string_view kKeyword = "density_file";
  std::shared_ptr<const DensityVolume> volume;  // never null
  int interpolate = 0;                          // as written; n mod 10 counts: 0 none, 1 linear, else cubic
};

double evaluate(const DensityFile& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
