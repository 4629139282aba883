#include "engine/output/code_table.hpp"

#include <bit>
#include <limits>

namespace lute {

namespace {

// The least positive float whose code is at least `wanted`.
float least_with(const std::function<int(float)>& code, int wanted) {
  std::uint32_t below = 0, reached = std::bit_cast<std::uint32_t>(1.0f);
  while (reached - below > 1) {
    const std::uint32_t middle = below + (reached - below) / 2;
    (code(std::bit_cast<float>(middle)) >= wanted ? reached : below) = middle;
  }
  return std::bit_cast<float>(reached);
}

}  // namespace

CodeTable::CodeTable(const std::function<int(float)>& code, int max) : max_(max), least_{0.0f} {
  for (int wanted = 1; wanted <= max; ++wanted) least_.push_back(least_with(code, wanted));
  least_.push_back(std::numeric_limits<float>::infinity());
  int reached = 0;
  for (int i = 0; i < kCoarse; ++i) {
    const float begin = static_cast<float>(i) / kCoarse;
    while (begin >= least_[static_cast<std::size_t>(reached) + 1]) ++reached;
    first_.push_back(static_cast<std::uint16_t>(reached));
  }
}

}  // namespace lute
