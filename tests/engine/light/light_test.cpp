// Light groups and projected lights (specification chapter 40 §10.5, §11.5), beyond the check cases in
// tests/scene/shading_cases_test.cpp.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TexturePtr white_diffuse() {
  return texture(rgbft(1, 1, 1), finish([](Finish& f) { f.diffuse = 1; }));
}

TEST(LightGroup, LightsItsMembersOnly) {  // §10.5
  auto member = wall(white_diffuse());
  auto group = csg(CsgOperation::kLightGroup, {light({0, 0, -100}, Rgb(.25f)), member});
  expect_grey(look(scene({sun(), group}), camera()), .25f);
  group->extras.edit().global_lights = true;
  expect_grey(look(scene({sun(), group}), camera()), 1.25f);
  auto outside = csg(CsgOperation::kLightGroup, {light({0, 0, -100}, Rgb(.25f))});
  expect_grey(look(scene({sun(), outside, wall(white_diffuse())}), camera()), 1);
}

// §10.5: the check cases 20 have the same from POV-Ray.
TEST(LightGroup, DeclaredInnerGroupsSeeTheLightsOfOuterOnes) {
  const auto look_at_groups = [](bool declared) {
    auto inner = csg(CsgOperation::kLightGroup, {wall(white_diffuse()), light({0, 0, -100}, Rgb(.5f))});
    inner->declared = declared;
    auto outer = csg(CsgOperation::kLightGroup, {inner, light({0, 0, -100}, Rgb(.125f))});
    return look(scene({outer}), camera());
  };
  expect_grey(look_at_groups(false), .5f);
  expect_grey(look_at_groups(true), .625f);
}

TEST(ProjectedLight, ShinesThroughItsObjectOnly) {  // §11.5
  const auto through = [](dvec3 center) {
    return light({0, 0, -100}, Rgb(1.0f), [&](LightSource& l) { l.projected_through = object(sphere(center, 1)); });
  };
  expect_grey(look(scene({through({0, 0, -20}), wall(white_diffuse())}), camera()), 1);
  expect_grey(look(scene({through({9, 0, -20}), wall(white_diffuse())}), camera()), 0);
}

}  // namespace
}  // namespace lute::testing
