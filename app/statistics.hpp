// The summary of --stats: rays by kind, tests, time by stage, the estimated error of the picture.
#pragma once

#include <chrono>
#include <string>

#include "engine/render/render.hpp"

namespace lute {

// Seconds of each stage of a frame.
struct StageTimes {
  double parse = 0, build = 0, render = 0, write = 0;
};

// Runs from its construction on.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string statistics_text(const RenderResult& result, const StageTimes& times, long pixels);

}  // namespace lute
