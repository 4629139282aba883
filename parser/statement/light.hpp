// light_source { ... } and light_group { ... } (specification chapter 11 §6).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// What stands between the braces of a light_source without identifier.
LightSource parse_light_items(Reader& reader);

// transformations, global_lights, photons: what follows the objects of a light_group.
void parse_light_group_items(Reader& reader, Object& group);

}  // namespace lute
