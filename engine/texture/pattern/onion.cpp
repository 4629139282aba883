#include "engine/texture/pattern/onion.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Onion&, const dvec3& p, const PatternContext&) { return fraction(glm::length(p)); }

}  // namespace lute
