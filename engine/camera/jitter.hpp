// The jitter of antialiasing and focal blur: a function of the image position alone, so that it is the same in every
// run and thread. Source: specification chapter 30 §5.2.
#pragma once

#include "engine/math/vec.hpp"

namespace lute {

// Both components in [-0.5, 0.5).
dvec2 jitter(dvec2 position);

}  // namespace lute
