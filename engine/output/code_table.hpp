// A rising function from intensity to whole codes, tabulated: the exact codes of the function at a tenth of its cost.
//
// The function is known completely by the least float that has each code; those are found by halving, since positive floats
// are in the order of their bits. A lookup begins at a coarse table and steps to the code.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace lute {

class CodeTable {
 public:
  // `code` must not fall, be 0 at 0 and `max` at 1.
  CodeTable(const std::function<int(float)>& code, int max);

  // The code of `value`; below 0 and NaN count as 0, above 1 as 1.
  int operator()(float value) const {
    if (!(value > 0)) return 0;
    if (value >= 1) return max_;
    int code = first_[static_cast<std::size_t>(value * kCoarse)];
    while (value >= least_[static_cast<std::size_t>(code) + 1]) ++code;
    return code;
  }

 private:
  static constexpr int kCoarse = 4096;

  int max_;
  std::vector<float> least_;          // of each code; behind the last one a value that is never reached
  std::vector<std::uint16_t> first_;  // the code at the beginning of each of the coarse intervals
};

}  // namespace lute
