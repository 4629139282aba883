#include "engine/texture/pattern/boxed.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double evaluate(const Boxed&, const dvec3& p, const PatternContext&) {
  return 1 - std::min(1.0, std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
}

}  // namespace lute
