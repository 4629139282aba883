// Internal functions made of noise: multifractals, f_noise3d, f_noise_generator (specification chapter 21 §11.5).
#pragma once

#include "engine/function/function.hpp"

namespace lute {

// Arguments as the language passes them: x, y, z, then H, lambda, octaves, ... as the chapter lists them.
double hetero_multifractal(const double* a);
double ridge(const double* a);
double ridged_multifractal(const double* a);

// 76 noise3d (x, y, z), 77 pattern (always 0 without a pattern), 78 noise_generator (x, y, z, generator); else null.
FunctionPtr noise_function(int index, int noise_generator);

}  // namespace lute
