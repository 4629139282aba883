// The sources of ripples and waves: number_of_waves positions on the unit sphere, each with a frequency.
// Source: specification chapter 50 §6, measured table.
#pragma once

#include <vector>

#include "engine/math/vec.hpp"

namespace lute {

struct WaveSources {
  std::vector<dvec3> positions;      // unit vectors
  std::vector<double> frequencies;
};

WaveSources make_wave_sources(int count);  // count >= 1

}  // namespace lute
