// Antialiasing method 2: a pixel is the mean of its corners; where those differ it is divided into four, again and
// again. Source: specification chapter 30 §6.2.
#pragma once

#include "engine/render/antialias.hpp"

namespace lute {

void render_adaptive_block(const PixelArea& block, const Antialiasing& settings, const ColorMetric& metric,
                           PixelSource& source, Film& film, const ErrorRecord* errors);

}  // namespace lute
