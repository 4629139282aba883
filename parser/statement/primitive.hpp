// The table of primitives: keyword and parser. A parser reads what stands between the brace and the object modifiers.
// To add a shape: its line in engine/shape/table.hpp, its parser, its line in primitive.cpp.
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
