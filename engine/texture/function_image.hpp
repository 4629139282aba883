// `function WIDTH, HEIGHT { f }` in place of an image file: the function sampled over the unit square, row 0 at y = 0
// (specification chapter 50 §11.3).
#pragma once

#include "engine/function/function.hpp"
#include "engine/image/image.hpp"

namespace lute {

// 16 bits grey for a float function, 16 bits RGBA for a pigment function. Width and height are at least 1.
ImagePtr sample_function(const Function& function, int width, int height);

}  // namespace lute
