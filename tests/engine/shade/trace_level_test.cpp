// Trace levels (specification chapter 40 §3.1), beyond the check cases in tests/scene/shading_cases_test.cpp.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TEST(TraceLevel, DoesNotCountStraightRaysButEndsThem) {  // §3.1
  Scene s = with_background(scene({}), kBlueSky);
  for (int i = 0; i < 50; ++i) s.objects.push_back(object(plane({0, 0, -1}, -i), texture(rgbt(1, 1), finish(0, 0))));
  expect_rgb(look(s, camera()), .2f, .4f, .8f);
  s.settings.max_trace_level = 1;
  expect_rgb(look(s, camera()), 0, 0, 0);
}

}  // namespace
}  // namespace lute::testing
