// color_map, pigment_map, density_map, normal_map, slope_map, texture_map (specification chapter 11 §10.6).
#pragma once

#include <functional>
#include <string>

#include "parser/reader.hpp"
#include "parser/statement/pattern.hpp"

namespace lute {

// `{ ... }` after the keyword. `average`: entries are weights, which may be left out.
ColorMapPtr parse_color_map(Reader& reader);
SlopeMapPtr parse_slope_map(Reader& reader);
PigmentMapPtr parse_pigment_map(Reader& reader, bool average);
PigmentMapPtr parse_density_map(Reader& reader, bool average);
NormalMapPtr parse_normal_map(Reader& reader, bool average);
TextureMapPtr parse_texture_map(Reader& reader, bool average);

// Stops with the reference's message for a pattern that does not take a map.
[[noreturn]] void refuse_map(Reader& reader, Word map);
// Does so where it does not.
void require_map_allowed(Reader& reader, const PatternBody& body, Word map);

}  // namespace lute
