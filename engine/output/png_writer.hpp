// PNG through libpng, with the chunks that POV-Ray writes: gAMA, sRGB, sBIT, and the program's name as text. No time:
// equal pictures are equal files. Source: specification chapter 30 §7.8.
#pragma once

#include <string>

#include "engine/output/encode.hpp"

namespace lute {

// Throws std::runtime_error.
void write_png(const std::string& path, const EncodedImage& image, const GammaCurve& declared);

}  // namespace lute
