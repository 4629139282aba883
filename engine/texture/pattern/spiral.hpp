// What spiral1 and spiral2 share.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

// z + distance from the z axis + arms times the turn around it, with classic turbulence along it (specification chapter 50 §6).
double spiral_phase(const dvec3& p, int arms, const PatternContext& context);

}  // namespace lute
