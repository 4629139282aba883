#include "engine/texture/pattern/cells.hpp"

#include <cmath>

#include "engine/math/rounding.hpp"
#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Cells&, const dvec3& p, const PatternContext&) {
  const auto cell = [](double c) { return cell_number(fast_floor(c + kEpsilon)); };
  return random_table(hash3(cell(p.x), cell(p.y), cell(p.z)));
}

}  // namespace lute
