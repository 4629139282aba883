// background, sky_sphere, fog, rainbow (specification chapter 11 §2, §5). `{ ... }` after the keyword.
#pragma once

#include "parser/reader.hpp"

namespace lute {

Color parse_background(Reader& reader);
SkySphere parse_sky_sphere(Reader& reader);
Fog parse_fog(Reader& reader);
Rainbow parse_rainbow(Reader& reader);

}  // namespace lute
