#include "engine/texture/pattern/cylindrical.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double evaluate(const Cylindrical&, const dvec3& p, const PatternContext&) {
  return 1 - std::min(1.0, std::sqrt(p.x * p.x + p.z * p.z));
}

}  // namespace lute
