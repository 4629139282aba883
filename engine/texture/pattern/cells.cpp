#include "engine/texture/pattern/cells.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/rounding.hpp"
#include "engine/texture/noise.hpp"

namespace lute {

double evaluate(const Cells&, const dvec3& p, const PatternContext&) {
  const auto cell = [](double c) {
    return static_cast<std::int64_t>(fast_floor(std::clamp(c, -9e15, 9e15) + kEpsilon));
  };
  return random_table(hash3(cell(p.x), cell(p.y), cell(p.z)));
}

}  // namespace lute
