// PPM (P6) and PGM (P5), one byte a sample up to 8 bits, else two, the larger first. Source: specification chapter 30
// §7.7-7.8.
#pragma once

#include <string>

#include "engine/output/encode.hpp"

namespace lute {

// One channel gives a PGM, three a PPM. Throws std::runtime_error.
void write_pnm(const std::string& path, const EncodedImage& image);

}  // namespace lute
