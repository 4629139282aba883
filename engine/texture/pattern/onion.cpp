#include "engine/texture/pattern/onion.hpp"

#include <cmath>

namespace lute {

double evaluate(const Onion&, const dvec3& p, const PatternContext&) { return std::fmod(glm::length(p), 1.0); }

}  // namespace lute
