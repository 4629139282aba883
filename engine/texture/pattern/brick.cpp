#include "engine/texture/pattern/brick.hpp"

#include "engine/math/rounding.hpp"

namespace lute {

double evaluate(const Brick& pattern, const dvec3& p, const PatternContext&) {
  const double mortar = static_cast<double>(static_cast<float>(static_cast<double>(pattern.mortar) - 2 * kEpsilon));
  const dvec3 q = p + dvec3(mortar + kEpsilon);
  const auto in_layer = [](double v) {
    const double r = fraction(v);
    return r < 0 ? r + 1 : r;
  };
  // Written so that bricks without size are mortar everywhere.
  const auto in_mortar = [](double place, double width) { return !(place > width); };
  const dvec3& size = pattern.size;
  if (in_mortar(in_layer(q.y / size.y), mortar / size.y)) return 0;
  // Every other layer is shifted by half a brick.
  const double shift_x = in_layer(q.y / (2 * size.y)) <= 0.5 ? 0 : 0.5;
  if (in_mortar(in_layer(q.x / size.x + shift_x), mortar / size.x)) return 0;
  if (in_mortar(in_layer(q.z / size.z + (0.5 - shift_x)), mortar / size.z)) return 0;
  return 1;
}

}  // namespace lute
