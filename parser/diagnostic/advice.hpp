// What to write instead, for errors where that is known. Messages themselves are POV-Ray's, so that they can be looked up.
#pragma once

#include <string>

#include "parser/diagnostic/diagnostic.hpp"

namespace lute {

// "" where nothing useful can be said. `excerpt` and the marked columns of the diagnostic tell what was found.
std::string advice(const Diagnostic& diagnostic);

// For an index that none of `count` things has: "the vertices are counted from 0 to 2, this is 3".
std::string index_advice(std::string_view what, std::size_t count, double index);

}  // namespace lute
