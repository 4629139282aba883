// The bodies of patches and of surfaces made by functions: what stands between `{` and the object's modifiers (specification
// chapters 11 §7, 21).
#pragma once

#include "engine/shape/bicubic_patch.hpp"
#include "engine/shape/isosurface.hpp"
#include "engine/shape/parametric.hpp"
#include "engine/shape/polygon.hpp"
#include "parser/reader.hpp"

namespace lute {

Polygon parse_polygon(Reader& reader);
BicubicPatch parse_bicubic_patch(Reader& reader);
Isosurface parse_isosurface(Reader& reader);
Parametric parse_parametric(Reader& reader);

}  // namespace lute
