// pigment { ... } and density { ... } (specification chapter 11 §10).
#pragma once

#include "parser/reader.hpp"
#include "parser/statement/pattern.hpp"

namespace lute {

// `{ ... }` after the keyword. What is not written stays as `base` has it.
PigmentPtr parse_pigment(Reader& reader, const PigmentPtr& base);
PigmentPtr parse_density(Reader& reader);  // starts empty

// The inside of the block, as map entries have it; `kind` is kPigment or kDensity.
PigmentPtr parse_pigment_items(Reader& reader, const PigmentPtr& base, BodyKind kind);

// `{ ... }` of `function { pattern { ... } }`: only the body counts.
PigmentPtr parse_function_pattern(Reader& reader);

// One item of the pigment of a texture of versions below 3.0, where pigment items stand directly in the texture.
bool accept_old_pigment_item(Reader& reader, Pigment& pigment);

}  // namespace lute
