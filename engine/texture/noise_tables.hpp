// The tables behind the lattice noise, for those who want its formula in another form.
#pragma once

#include <cstdint>

namespace lute {

struct NoiseTables {
  const std::uint16_t* hash;  // 4096 permuted numbers, twice over
  const double* gradients;    // T of specification chapter 50 §2.2: 267 numbers
};

NoiseTables noise_tables();

}  // namespace lute
