// `function { internal(n) }`: the built-in functions that functions.inc gives names to (f_sphere, f_torus, f_noise3d, ...).
// All take x, y, z first. Source: specification chapter 21 §11.5; the order of the table is the language's numbering.
#pragma once

#include <span>
#include <string_view>

#include "engine/function/function.hpp"

namespace lute {

struct InternalFunction {
  std::string_view name;  // without "f_"
  int parameters = 3;     // x, y, z included
  double (*evaluate)(const double* a) = nullptr;           // a[0..2] = x, y, z; then the parameters
  Enclosure (*enclose)(const Enclosure* a) = nullptr;      // null: no bounds are known
};

// Indices 0 to 75: closed formulas. The noise functions follow in noise_functions.
std::span<const InternalFunction> internal_functions();

// Function `index`, or null where there is none. `noise_generator` (1, 2, 3) is what f_noise3d uses.
FunctionPtr internal_function(int index, int noise_generator);

}  // namespace lute
