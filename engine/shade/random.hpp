// Random numbers as a function of (pixel, sample, dimension): the same for any number of threads and any order of tiles. Each draw
// is the next dimension. The mixing function is that of splitmix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number
// generators", 2014).
#pragma once

#include <cstdint>

namespace lute {

class SampleRandom {
 public:
  void start(std::uint64_t pixel, std::uint64_t sample) { state_ = mix(mix(pixel + 0x9E3779B97F4A7C15u) ^ (sample * 0xD1B54A32D192ED03u)); }

  // Uniform in [0, 1).
  double next() {
    state_ += 0x9E3779B97F4A7C15u;
    return static_cast<double>(mix(state_) >> 11) * 0x1p-53;
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_ = 0;
};

}  // namespace lute
