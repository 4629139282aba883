// Advice that needs the text around the mistake: words of other languages, other spellings of operators and vectors, values without a
// #declare. Before that of advice.hpp.
#pragma once

#include <string>

#include "parser/diagnostic/diagnostic.hpp"

namespace lute {

// "" where nothing useful can be said.
std::string context_advice(const Diagnostic& diagnostic);

}  // namespace lute
