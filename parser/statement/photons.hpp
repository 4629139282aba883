// photons { ... } of objects (specification chapter 11 §8).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword.
void parse_object_photons(Reader& reader, Object& object);

}  // namespace lute
