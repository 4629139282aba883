#include "engine/texture/pattern/spherical.hpp"

#include <algorithm>

namespace lute {

double evaluate(const Spherical&, const dvec3& p, const PatternContext&) { return 1 - std::min(1.0, glm::length(p)); }

}  // namespace lute
