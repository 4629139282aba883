// Finishes whose numbers POV-Ray's random numbers decide. The check cases of specification chapter 40 §19
// are in tests/scene/shading_cases_test.cpp.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TEST(Finish, CrandOnlyDarkens) {  // §7 step 7: i - u * crand, u in 0...1; the stream of u is our own
  const auto grainy = finish([](Finish& f) { f.diffuse = .5f, f.crand = .4f; });
  const Color seen = look(scene({sun(), wall(texture(rgbft(1, 1, 1), grainy))}), camera());
  EXPECT_LE(seen.rgb.r, .5f);
  EXPECT_GE(seen.rgb.r, .1f);
}

}  // namespace
}  // namespace lute::testing
