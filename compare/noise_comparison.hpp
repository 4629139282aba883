// The noise of both programs at many points, far beyond what a picture of 8 bits shows.
//
// A scene of one plane is rendered twice with 16 bits: once with the noise itself, once with a thousand times the noise modulo 1. The
// first tells the value to 1/65535, the second adds three digits: together they resolve 1.6e-8. The points lie on a tilted plane
// through about a hundred lattice cells in each direction, at positive and negative coordinates.
#pragma once

#include <cstddef>
#include <string>

#include "compare/renderer.hpp"

namespace lute::compare {

struct NoiseComparison {
  int generator = 1;
  std::size_t points = 0;
  double largest = 0, mean = 0;  // differences of the noise, which is 0...1
};

// What 16 bits of a thousand times the noise can tell apart.
constexpr double kNoiseResolution = 1.0 / 65535 / 1000;

// `side`² points. Throws std::runtime_error when a program does not render the scene.
NoiseComparison compare_noise(int generator, int side, const std::string& lute_program, const std::string& reference_program,
                              double time_limit = 600);

}  // namespace lute::compare
