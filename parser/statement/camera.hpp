// camera { ... } with all of its arithmetic (specification chapters 11 §4 and 30 §2).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword. `start`: what is not written stays as it is.
Camera parse_camera(Reader& reader, const Camera& start);

}  // namespace lute
