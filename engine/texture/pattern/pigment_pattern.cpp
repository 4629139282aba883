#include "engine/texture/pattern/pigment_pattern.hpp"

#include "engine/texture/compiled_pigment.hpp"

namespace lute {

double evaluate(const PigmentPattern&, const dvec3& p, const PatternContext& context) {
  Color color;
  if (!context.pigment->evaluate(p, *context.surface, color)) return 0;
  return static_cast<double>(grey(color.rgb));
}

}  // namespace lute
