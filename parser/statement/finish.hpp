// finish { ... } (specification chapters 11 §9.5 and 40 §6).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// The keyword was taken. Starts from `base`, or from the finish that the block names first.
FinishPtr parse_finish(Reader& reader, const FinishPtr& base);

}  // namespace lute
