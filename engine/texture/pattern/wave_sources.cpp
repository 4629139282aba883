#include "engine/texture/pattern/wave_sources.hpp"

#include <cstdint>

#include "engine/texture/noise.hpp"

namespace lute {

WaveSources make_wave_sources(int count) {
  WaveSources sources;
  std::uint32_t state = static_cast<std::uint32_t>(-560851967);
  for (int i = 0; i < count; ++i) {
    sources.positions.push_back(glm::normalize(vector_noise({i, 0, 0})));
    state = 1812433253u * state + 12345u;
    sources.frequencies.push_back(static_cast<double>((state >> 16) & 0x7FFFu) * 0.000030518509476 + 0.01);
  }
  return sources;
}

}  // namespace lute
