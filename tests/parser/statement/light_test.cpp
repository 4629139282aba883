// Lights and light groups (specification chapter 11 §6).
#include "tests/parser/statement/scene_text.hpp"

namespace lute::test {
namespace {

LightSource light_of(const std::string& items) {
  return *only_object(scene_of(kVersion + "light_source { " + items + " }")).light();
}

TEST(Lights, TransformationsActAtOnce) {
  const LightSource light = light_of("0, 1 spotlight point_at z translate x area_light x, y, 2, 3 rotate 90*z");
  EXPECT_NEAR(light.location.y, 1, 1e-12);
  EXPECT_NEAR(light.point_at.y, 1, 1e-12);
  ASSERT_TRUE(light.area);
  EXPECT_NEAR(light.area->axis1.y, 1, 1e-12);
  EXPECT_EQ(light.area->size2, 3);
}

TEST(Lights, CylinderLightsAreParallel) {
  const LightSource light = light_of("0, 1 cylinder");
  EXPECT_TRUE(light.parallel);
  EXPECT_EQ(light.radius, 0.75);
  EXPECT_EQ(light.falloff, 1);
}

TEST(Lights, OrientMakesAnAreaLightCircular) {
  EXPECT_TRUE(light_of("0, 1 area_light x, y, 2, 2 orient").area->circular);
  EXPECT_EQ(rejection_of(kVersion + "light_source { 0, 1 area_light x, y, 1, 2 circular }"),
            "Circular area light must have more than 1 point per axis");
  EXPECT_EQ(rejection_of(kVersion + "light_source { 0, 1 area_light x, y, 0, 2 }"), "Area size must be greater than zero.");
}

TEST(Lights, LooksLikeStartsFromTheLightsPlace) {
  const LightSource light = light_of("y, 1 looks_like { sphere { 0, 1 } scale 2 } translate x");
  ASSERT_NE(light.looks_like, nullptr);
  EXPECT_TRUE(light.looks_like->no_shadow);
  EXPECT_EQ(light.looks_like->transform->translation, dvec3(1, 2, 0));  // moved to the light, scaled, moved along
}

TEST(Lights, AColorMapSumsUp) {  // case 19
  const LightSource light = light_of("-10*z 1 color_map { [0.5 rgb x] [1 rgb z] }");
  EXPECT_EQ(light.color, Rgb(0.5f, 0, 1));
}

TEST(Lights, TakeNoObjectModifiers) {
  EXPECT_THAT(rejection_of(kVersion + "light_source { 0, 1 no_shadow }"), testing::HasSubstr("No matching } in 'light_source'"));
  EXPECT_EQ(rejection_of(kVersion + "object { light_source { 0, 1 } no_shadow }"), "");
}

TEST(Lights, GroupsLetGlobalLightsInOnlyWhenTold) {  // case 20
  const auto global = [](const std::string& items) {
    return only_object(scene_of(kVersion + "light_group { light_source { 0, 1 } sphere { 0, 1 } " + items + " }")).extras->global_lights;
  };
  EXPECT_EQ(global(""), std::nullopt);
  EXPECT_EQ(global("global_lights"), true);
  EXPECT_EQ(global("global_lights .5"), false);
}

}  // namespace
}  // namespace lute::test
