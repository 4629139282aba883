// A shape that no ray ever hits and no point is inside of: what degenerate descriptions become (specification chapter 20 §10).
#pragma once

#include <memory>

#include "engine/shape/shape.hpp"

namespace lute {

std::unique_ptr<Shape> build_empty_shape(bool patch);

}  // namespace lute
