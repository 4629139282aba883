// warp { ... } (specification chapters 11 §10.8 and 50 §5).
#pragma once

#include "parser/reader.hpp"

namespace lute {

// The keyword was taken. The warp goes to the front of the chain.
void parse_warp(Reader& reader, WarpChain& chain);

// turbulence, octaves, omega, lambda: edits `turbulence` if one of them comes next. `turbulence` itself only when `amount` is set.
bool accept_turbulence_item(Reader& reader, Turbulence& turbulence);

// The classic turbulence of a chain, made at its end when there is none.
Turbulence& classic_turbulence(WarpChain& chain);

}  // namespace lute
