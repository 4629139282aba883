// Renders an image: blocks on a number of threads, each block a pure function of the source, the settings and its
// index. The film is bit-identical for every number of threads. Source: specification chapter 30 §6, §8.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "engine/render/antialias.hpp"

namespace lute {

struct RenderSettings {
  PixelArea area;  // the part to render; the film has the full size
  int block_size = 32;
  int threads = 1;
  Antialiasing antialiasing;
  GammaMode gamma_mode = GammaMode::kPower;  // the working space, for the comparison of colours
  double assumed_gamma = 1;
  bool alpha = false;           // transparency is seen: its error counts
  bool estimate_error = false;  // method 3 does anyway

  bool estimates() const { return estimate_error || antialiasing.error_driven(); }
};

struct RenderProgress {
  // After every block, one call at a time but from any thread; pixels done so far and in all.
  std::function<void(long done, long total)> report;
  // Set from anywhere, a signal handler included: no further block is begun.
  const std::atomic<bool>* cancel = nullptr;
};

struct RenderResult {
  bool complete = true;  // false: cancelled
  Counters counters;
  // The estimated error of the picture, from the samples taken: root mean square over pixels and channels, in coded
  // values 0...1 as an sRGB file has them.
  std::optional<double> estimated_error;
};

RenderResult render(const RenderSettings& settings, const MakePixelSource& make_source, Film& film,
                    const RenderProgress& progress = {});

}  // namespace lute
