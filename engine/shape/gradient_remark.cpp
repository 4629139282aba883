#include "engine/shape/gradient_remark.hpp"

#include <array>
#include <cstdio>

namespace lute {

std::string GradientRemark::text() const {
  const bool too_small = found > 1.05 * set, too_large = set > found + 10 || (set > found + 0.5 && set > 1.1 * found);
  if (found == 0 || (!too_small && !too_large)) return {};
  const char* advice = too_large ? "a smaller one takes less time"
                       : proven  ? "proofs stand in for it, which takes longer"
                                 : "the isosurface may contain holes";
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), "the maximum gradient found was %.3f, but max_gradient of the isosurface was set to %.3f; %s", found,
                set, advice);
  return text.data();
}

}  // namespace lute
