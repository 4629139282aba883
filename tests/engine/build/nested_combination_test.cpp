// Combinations that are dissolved into those around them.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

// Of two equal spheres one wall stays (chapter 20 §5.1; in the reference rounding decides), wherever in the intersection they are.
TEST(NestedIntersections, OfEqualSpheresShowOneWall) {
  const auto ball = [] { return object(sphere(dvec3(0.1, 0.2, 0.3), 1), texture(rgbt(1), finish(1, 0))); };
  const auto slab = [] { return object(box(dvec3(-2), dvec3(2)), texture(rgbt(.25f), finish(1, 0))); };
  const auto both = [](std::vector<ObjectPtr> parts) { return csg(CsgOperation::kIntersection, std::move(parts)); };
  const std::vector<ObjectPtr> forms{both({ball(), ball(), slab()}), both({ball(), both({ball(), slab()})}),
                                     both({both({ball(), slab()}), ball()}), both({both({ball(), slab()}), both({slab(), ball()})})};
  for (const ObjectPtr& form : forms)
    for (const double x : {-.5, -.1, .3, .8}) expect_grey(look(scene({form}), {{x, 0.2, -10}, {0, 0, 1}}), 1);
}

}  // namespace
}  // namespace lute::testing
