// translate, rotate, scale, matrix, transform (specification chapter 11 §13).
#pragma once

#include <optional>

#include "parser/reader.hpp"

namespace lute {

// The transformation, if one comes next.
std::optional<Transform> accept_transformation(Reader& reader);

// `transform IDENT` or `transform { ... }`; the keyword was taken.
Transform parse_transform(Reader& reader);

}  // namespace lute
