#include "engine/texture/pattern/julia.hpp"

namespace lute {

double evaluate(const Julia& pattern, const dvec3& p, const PatternContext&) {
  return iterate_power(pattern, pattern.exponent, {p.x, p.y}, {pattern.c.x, pattern.c.y});
}

}  // namespace lute
