// The noise of generators 1 and 2, vector noise and their turbulence, compiled for each instruction set: a vector of four lanes does the
// same additions in the same order whatever the processor, so results are bit-identical. Source: specification chapter 50 §2-3.
#pragma once

#include <algorithm>
#include "engine/texture/noise.hpp"

namespace lute {

// The sum over the corners of the cell, before a generator scales it.
double lattice_sum(const dvec3& p);
// octaves_of_noise() of generator 1 or 2.
void lattice_octaves(const dvec3& p, double first_scale, int generator, int count, double* out);
// Turbulence of generator 1 or 2.
double lattice_turbulence(const dvec3& p, const Turbulence& t, int generator);

// What generator 1 or 2 makes of the sum: 0...1.
inline double scaled_noise(double sum, int generator) {
  return std::clamp(generator == 1 ? sum + 0.5 : (sum + 1.05242) * 0.48985582, 0.0, 1.0);
}

}  // namespace lute
