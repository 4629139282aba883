#include "engine/texture/pattern/planar.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double evaluate(const Planar&, const dvec3& p, const PatternContext&) { return 1 - std::min(1.0, std::fabs(p.y)); }

}  // namespace lute
