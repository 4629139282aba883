// What a plan leaves out, and what it tells.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TEST(RenderPlan, OpaqueSceneNeedsNeitherTransmissionNorColoredShadows) {
  const RenderPlan plan = make_plan(scene({sun(), wall(texture(rgbft(1, 1, 1), finish(0, 1)))}));
  EXPECT_TRUE(plan.lights);
  EXPECT_TRUE(plan.shadows);
  EXPECT_FALSE(plan.filtered_shadows);
  EXPECT_FALSE(plan.transmission);
  EXPECT_FALSE(plan.reflection);
  EXPECT_FALSE(plan.volume_effects);
}

TEST(RenderPlan, OneClearSurfaceNeedsThem) {
  const RenderPlan plan = make_plan(scene({sun(), wall(texture(rgbt(1, 1), finish(0, 1)))}));
  EXPECT_TRUE(plan.filtered_shadows);
  EXPECT_TRUE(plan.transmission);
}

TEST(RenderPlan, LowQualityLeavesOut) {
  BuildOptions options;
  options.quality = 3;
  const auto mirror = finish([](Finish& f) { f.reflection_max = Rgb(1.0f); });
  const RenderPlan plan = make_plan(scene({sun(), wall(texture(rgbt(1, 1), mirror))}), options);
  EXPECT_FALSE(plan.shadows);
  EXPECT_FALSE(plan.transmission);
  EXPECT_FALSE(plan.reflection);
}

TEST(RenderPlan, ReasonsNameTheLineOfTheScene) {
  auto lamp = light({0, 0, 0}, Rgb(1.0f), [](LightSource& l) { l.where = {0, 12, 1}; });
  Scene s = scene({lamp});
  s.files = {"lute.pov"};
  const RenderPlan plan = make_plan(s);
  EXPECT_NE(plan.text(s).find("needed because a light casts shadows (lute.pov:12)"), std::string::npos) << plan.text(s);
  EXPECT_NE(plan.json(s).find("\"name\": \"shadow\", \"needed\": true"), std::string::npos) << plan.json(s);
}

}  // namespace
}  // namespace lute::testing
