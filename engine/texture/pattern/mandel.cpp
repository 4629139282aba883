#include "engine/texture/pattern/mandel.hpp"

namespace lute {

double evaluate(const Mandel& pattern, const dvec3& p, const PatternContext&) {
  const FractalPoint z{p.x, p.y};
  return iterate_power(pattern, pattern.exponent, z, z);
}

}  // namespace lute
