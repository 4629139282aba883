#include "engine/texture/pattern/hexagon.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Hexagon&, const dvec3& p, const PatternContext&) {
  static constexpr int kSide[6] = {0, 1, 1, 2, 2, 0}, kMiddle[6] = {2, 2, 0, 0, 1, 1};
  static constexpr int kLow[6] = {0, 2, 1, 0, 2, 1}, kHigh[6] = {2, 1, 0, 2, 1, 0};
  const double x = std::fabs(p.x), z = p.z >= 0 ? p.z : 5.196152424 - std::fabs(p.z);
  double u = x / 0.5, w = z / 0.866025404;
  u -= 6 * fast_floor(u / 6);
  w -= 6 * fast_floor(w / 6);
  // Far away the difference is rounded to anything.
  const auto side = [](double v) { return static_cast<int>(std::clamp(v, 0.0, 5.0)); };
  const int i = side(u), j = side(w);
  if (i == 0 || i == 5) return kSide[j];
  if (i == 2 || i == 3) return kMiddle[j];
  double a = u - i;
  const double b = w - j;
  if ((i + j) % 2 == 1) a = 1 - a;
  if (a == 0) a = 0.0001;
  return b / a < 1 ? kLow[j] : kHigh[j];
}

}  // namespace lute
