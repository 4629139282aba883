// The table of primitives: keyword and parser. A parser reads what stands between the brace and the object modifiers.
// Some keywords make the same shape (cubic, poly, ...), so there are more than alternatives of AnyShape. To add a shape, see
// engine/shape/shape.hpp.
// Source: specification chapters 11 §7, 20 §5 and 21.
#pragma once

#include <span>

#include "parser/reader.hpp"

namespace lute {

using Geometry = decltype(Object::geometry);

struct Primitive {
  Word word;
  Geometry (*parse)(Reader&);
};

std::span<const Primitive> primitives();

}  // namespace lute
