#include "engine/texture/pattern/tiling.hpp"

#include "engine/texture/pattern/penrose_tiling.hpp"
#include "engine/texture/pattern/polygon_tiling.hpp"

namespace lute {

double evaluate(const Tiling& pattern, const dvec3& p, const PatternContext&) {
  switch (pattern.number) {
    case 25: return penrose_pentagons(p.x, p.z);
    case 26: return penrose_kites_and_darts(p.x, p.z);
    case 27: return penrose_rhombs(p.x, p.z);
    default: return polygon_tiling(pattern.number).value({p.x, p.z});
  }
}

}  // namespace lute
