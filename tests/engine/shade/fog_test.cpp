// Where fog is (specification chapter 40 §3), beyond the check cases in tests/scene/shading_cases_test.cpp.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

Fog fog(double distance, Color color) {
  Fog f;
  f.distance = distance;
  f.color = color;
  return f;
}

Color through(std::vector<Fog> fogs, std::vector<ObjectPtr> objects) {
  Scene s = scene(std::move(objects));
  s.fogs = std::move(fogs);
  return look(s, {{0, 0, 0}, {0, 0, 1}});
}

MutableObject slab(FinishPtr f) { return object(box({-9, -9, 5}, {9, 9, 6}), texture(rgbft(1, 1, 1), std::move(f))); }

TEST(Fog, VanishesInsideWhatIsNotHollow) {  // §3: a camera below a plane
  auto ground = object(plane({0, 1, 0}, 10), texture(rgbft(1, 1, 1), finish(1, 0)));
  expect_grey(through({fog(10, rgbft(0, 0, 0))}, {slab(finish(1, 0)), ground}), 1);
  ground->hollow = true;
  expect_grey(through({fog(10, rgbft(0, 0, 0))}, {slab(finish(1, 0)), ground}), .60653f);
}

}  // namespace
}  // namespace lute::testing
