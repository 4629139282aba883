// The tables behind the lattice noise, for those who want its formula in another form (bench/noise_bench.cpp).
#pragma once

namespace lute {

// T of specification chapter 50 §2.2: 267 numbers.
const double* noise_gradients();

}  // namespace lute
