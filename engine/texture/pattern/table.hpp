// The table of patterns: one line each.
#pragma once

#include <variant>

#include "engine/texture/pattern/brick.hpp"
#include "engine/texture/pattern/checker.hpp"
#include "engine/texture/pattern/gradient.hpp"
#include "engine/texture/pattern/hexagon.hpp"

namespace lute {

using AnyPattern = std::variant<  //
    Brick,                        //
    Checker,                      //
    Gradient,                     //
    Hexagon>;

}  // namespace lute
