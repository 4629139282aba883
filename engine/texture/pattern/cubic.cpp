#include "engine/texture/pattern/cubic.hpp"

#include <cmath>

namespace lute {

double evaluate(const Cubic&, const dvec3& p, const PatternContext&) {
  const double x = std::fabs(p.x), y = std::fabs(p.y), z = std::fabs(p.z);
  if (p.x >= 0 && p.x >= y && p.x >= z) return 0;
  if (p.y >= 0 && p.y >= x && p.y >= z) return 1;
  if (p.z >= 0 && p.z >= x && p.z >= y) return 2;
  if (x >= y && x >= z && p.x < 0) return 3;
  if (y >= x && y >= z && p.y < 0) return 4;
  return 5;
}

}  // namespace lute
