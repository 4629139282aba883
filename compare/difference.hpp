// How far two pictures of one size are apart.
//
// All figures use the coded values 0…1 of the files; a pixel's difference is the largest of its channels. A value that
// is not finite in one picture only counts as 1.
#pragma once

#include <cstddef>

#include "compare/picture.hpp"

namespace lute::compare {

struct Difference {
  double maximum = 0;        // 0…1
  double mean = 0;           // over pixels and colour channels, 0…1
  double rmse = 0;           // over pixels and colour channels, 0…1
  double psnr = 0;           // dB; infinite for equal pictures
  double within = 1;         // share of pixels whose every channel differs by at most the tolerance
  double tolerance_255 = 2;  // in 1/255
  double block98_255 = 0;    // 98th percentile of the differences of the means of 8×8 blocks, in 1/255
  std::size_t pixels = 0;
  bool alpha_compared = false;  // one of the pictures is not opaque everywhere
};

// Throws std::runtime_error when the sizes differ.
Difference difference(const Picture& a, const Picture& b, double tolerance_255 = 2);

// Black where the pictures agree, over blue, red and yellow to white at a difference of `full` (0…1).
Picture heat_map(const Picture& a, const Picture& b, double full = 32.0 / 255.0);

}  // namespace lute::compare
