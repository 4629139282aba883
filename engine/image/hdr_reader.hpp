// Radiance HDR files: for each pixel three bytes and the exponent they share, plain or run-length encoded in the old or the new way
// (Ward, "Real Pixels", Graphics Gems II, 1991).
//
// The library of formats is not asked: it gives the lower end of each byte's step, and the exponent, which is needed for the middle that the
// reference takes, cannot be had back from its values. As in the reference, FORMAT, EXPOSURE and the like change nothing, and the signs and
// letters of the size do neither: the first number is that of the rows, which stand from the top.
#pragma once

#include <string>
#include <vector>

namespace lute {

struct HdrContent {
  int width = 0, height = 0;
  std::vector<float> values;  // red, green, blue of each pixel, rows as stored
};

// False, with `error` set, when the file cannot be read.
bool read_hdr(const std::string& path, HdrContent& content, std::string& error);

}  // namespace lute
