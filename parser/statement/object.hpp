// Objects: primitives, CSG, lights, light groups, object { ... } and identifiers (specification chapter 11 §6-7).
#pragma once

#include <optional>

#include "parser/reader.hpp"

namespace lute {

// The object, if one comes next: with its keyword or as a bare identifier.
std::optional<ObjectPtr> accept_object(Reader& reader);

// A mesh block: the keyword was taken.
ObjectPtr parse_mesh_object(Reader& reader);

// Words that begin an object.
const std::vector<Word>& object_words();

}  // namespace lute
