#include "engine/texture/pattern/object_pattern.hpp"

#include "engine/texture/inside_test.hpp"

namespace lute {

double evaluate(const ObjectPattern&, const dvec3& p, const PatternContext& context) {
  return context.inside_test->inside(p) ? 1 : 0;
}

}  // namespace lute
