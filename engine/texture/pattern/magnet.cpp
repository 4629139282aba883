#include "engine/texture/pattern/magnet.hpp"

namespace lute {

double evaluate(const Magnet& pattern, const dvec3& p, const PatternContext&) {
  const FractalPoint z{p.x, p.y};
  if (!pattern.julia) return iterate_magnet(pattern, pattern.type, {}, z, 10000);
  return iterate_magnet(pattern, pattern.type, z, {pattern.julia->x, pattern.julia->y}, norm2(z));
}

}  // namespace lute
