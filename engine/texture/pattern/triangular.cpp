#include "engine/texture/pattern/triangular.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Triangular&, const dvec3& p, const PatternContext&) {
  const double root3 = std::sqrt(3.0);
  double u = p.x - 3 * fast_floor(p.x / 3), w = p.z - root3 * fast_floor(p.z / root3);
  const int a = static_cast<int>(std::clamp(fast_floor(u), 0.0, 3.0));  // far away u is rounded to anything
  u -= a;
  const bool top = w >= root3 / 2;
  if (top) w = root3 - w;
  int t = 1;
  if (u != 0) {
    const bool left = w / u < root3, right = w / (1 - u) < root3;
    t = left ? (right ? 0 : 3) : 1;
  }
  const int v = t % 2 == 1 ? (t + 2 * a) % 6 : (6 + t - 2 * a) % 6;
  return top ? 5 - v : v;
}

}  // namespace lute
