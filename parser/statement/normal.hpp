// normal { ... } (specification chapter 11 §10).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// `{ ... }` after the keyword. `base` may be null.
NormalPtr parse_normal(Reader& reader, const NormalPtr& base);

// The inside of the block, as map entries have it.
NormalPtr parse_normal_items(Reader& reader, const NormalPtr& base);

}  // namespace lute
