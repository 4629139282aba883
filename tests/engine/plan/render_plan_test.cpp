// What a plan leaves out, and what it tells.
#include <algorithm>

#include "engine/plan/output_plan.hpp"
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

bool needs(const RenderPlan& plan, const std::string& name) {
  return std::ranges::any_of(plan.items, [&](const PlanItem& item) { return item.name == name && item.needed; });
}

TEST(RenderPlan, OpaqueSceneNeedsNeitherTransmissionNorColoredShadows) {
  const RenderPlan plan = make_plan(scene({sun(), wall(texture(rgbft(1, 1, 1), finish(0, 1)))}));
  EXPECT_TRUE(plan.lights);
  EXPECT_TRUE(plan.shadows);
  EXPECT_FALSE(needs(plan, "shadow with colours"));
  EXPECT_FALSE(plan.transmission);
  EXPECT_FALSE(plan.reflection);
  EXPECT_FALSE(plan.volume_effects);
}

TEST(RenderPlan, OneClearSurfaceNeedsThem) {
  const RenderPlan plan = make_plan(scene({sun(), wall(texture(rgbt(1, 1), finish(0, 1)))}));
  EXPECT_TRUE(needs(plan, "shadow with colours"));
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

TEST(RenderPlan, WhatItLeavesOutIsNotBuilt) {
  Scene s = scene({wall(texture(rgbft(1, 1, 1), finish(0, 1)))});
  s.sky_sphere.emplace();
  s.fogs.resize(2);  // the second has no distance
  s.fogs[0].distance = 10;
  BuildOptions options;
  const auto whole = built_scene(s, options);
  EXPECT_EQ(whole->fogs.size(), 1u);
  EXPECT_NE(whole->sky, nullptr);
  options.quality = 8;
  EXPECT_TRUE(built_scene(s, options)->fogs.empty());
  s.sky_sphere.reset();
  EXPECT_EQ(built_scene(s, options)->sky, nullptr);
}

TEST(RenderPlan, ReasonsNameTheLineOfTheScene) {
  auto lamp = light({0, 0, 0}, Rgb(1.0f), [](LightSource& l) { l.where = {0, 12, 1}; });
  Scene s = scene({lamp});
  s.files = {"lute.pov"};
  const RenderPlan plan = make_plan(s);
  EXPECT_NE(plan.text(s).find("needed because a light casts shadows (lute.pov:12)"), std::string::npos) << plan.text(s);
  EXPECT_TRUE(needs(plan, "shadow"));
}

// A table is worth its making from 20000 codes on, for 8 bits, without dithering.
TEST(RenderPlan, CodesOfColoursAreTabledForLargePicturesOfEightBits) {
  const auto needed = [](const OutputSettings& output, bool to_file, int width, int height) {
    RenderPlan plan;
    plan_output(output, to_file, width, height, plan);
    return needs(plan, "codes of colours");
  };
  EXPECT_TRUE(needed({}, true, 100, 67));
  EXPECT_FALSE(needed({}, true, 100, 66));
  EXPECT_TRUE(needed({.alpha = true}, true, 100, 50));
  EXPECT_FALSE(needed({}, false, 320, 240));
  EXPECT_FALSE(needed({.bits = 16}, true, 320, 240));
  EXPECT_FALSE(needed({.dither = DitherMethod::kBayer2}, true, 320, 240));
  EXPECT_TRUE(needed({.format = FileFormat::kJpeg, .dither = DitherMethod::kBayer2}, true, 320, 240));
  EXPECT_FALSE(needed({.format = FileFormat::kOpenExr}, true, 320, 240));
}

}  // namespace
}  // namespace lute::testing
