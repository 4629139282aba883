// Check cases of specification chapter 40 §19: kinds of light and their shadows.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TexturePtr white_diffuse() {
  return texture(rgbft(1, 1, 1), finish([](Finish& f) { f.diffuse = 1; }));
}

float lit_at(const MutableObject& lamp, const dvec3& point, bool brilliant = true) {
  const auto f = finish([&](Finish& g) { g.diffuse = 1, g.brilliance = brilliant ? 1.0f : 0.0f; });
  const Scene s = scene({lamp, wall(texture(rgbft(1, 1, 1), f))});
  return look(s, {point - dvec3(0, 0, 5), {0, 0, 1}}).rgb.r;
}

TEST(Spotlight, ConeHasASoftEdge) {  // case 13
  const auto spot = light({0, 0, -10}, Rgb(1.0f), [](LightSource& l) { l.kind = LightKind::kSpot, l.point_at = dvec3(0); });
  const auto at = [&](double degrees) { return lit_at(spot, {10 * std::tan(radians(degrees)), 0, 0}, false); };
  EXPECT_NEAR(at(29), 1, 3e-5);
  EXPECT_NEAR(at(35), .79033, 3e-5);
  EXPECT_NEAR(at(40), .31061, 3e-5);
  EXPECT_NEAR(at(44), .01686, 3e-5);
  EXPECT_NEAR(at(46), 0, 3e-5);
}

TEST(Spotlight, TightnessNarrowsIt) {  // case 13: radius 0 falloff 45 tightness 10 at 20 degrees
  const auto spot = light({0, 0, -10}, Rgb(1.0f), [](LightSource& l) {
    l.kind = LightKind::kSpot, l.point_at = dvec3(0), l.radius = 0, l.tightness = 10;
  });
  EXPECT_NEAR(lit_at(spot, {10 * std::tan(radians(20)), 0, 0}, false), .47794, 3e-5);
}

TEST(CylinderLight, HasASoftEdge) {  // case 13
  const auto lamp = light({0, 0, -10}, Rgb(1.0f), [](LightSource& l) {
    l.kind = LightKind::kCylinder, l.parallel = true, l.point_at = dvec3(0), l.radius = .75, l.falloff = 1;
  });
  EXPECT_NEAR(lit_at(lamp, {.7, 0, 0}), 1, 3e-5);
  EXPECT_NEAR(lit_at(lamp, {.8, 0, 0}), .896, 3e-5);
  EXPECT_NEAR(lit_at(lamp, {.9, 0, 0}), .352, 3e-5);
}

TEST(FadingLight, FallsOffWithDistance) {  // case 14
  const auto lamp = light({0, 0, -100}, Rgb(1.0f), [](LightSource& l) { l.fade_distance = 50, l.fade_power = 2; });
  EXPECT_NEAR(lit_at(lamp, {0, 0, 0}), .4, 3e-5);
}

TEST(ParallelLight, LightsWhatIsBehindItWithoutShadow) {  // case 29
  const auto lamp = [](double fade) {
    return light({0, 0, 10}, Rgb(1.0f), [=](LightSource& l) {
      l.parallel = true, l.point_at = {0, 0, 20}, l.fade_distance = fade, l.fade_power = fade > 0 ? 2 : 0;
    });
  };
  auto blocker = object(box({-100, -100, -9}, {100, 100, -8}), white_diffuse());
  const Scene s = scene({lamp(0), wall(white_diffuse()), blocker});
  expect_grey(look(s, camera()), 1);
  expect_grey(look(scene({lamp(5), wall(white_diffuse())}), camera()), .4f);
}

TEST(ParallelLight, HasNoCone) {  // case 30
  const auto lamp = light({0, 0, -10}, Rgb(1.0f), [](LightSource& l) {
    l.kind = LightKind::kSpot, l.parallel = true, l.point_at = dvec3(0), l.radius = 10, l.falloff = 20;
  });
  EXPECT_NEAR(lit_at(lamp, {3, 0, 0}), 1, 3e-5);
}

float half_hidden(AreaLight area, double edge) {
  const auto lamp = light({0, 0, -100}, Rgb(1.0f), [&](LightSource& l) { l.area = area; });
  auto screen = object(box({-100, -100, -6}, {edge, 100, -5}), texture(rgbft(0, 0, 0), finish(0, 0)));
  screen->no_image = true;
  return look(scene({lamp, wall(white_diffuse()), screen}), camera()).rgb.r;
}

AreaLight grid(int n1, int n2) {
  AreaLight a;
  a.axis1 = {20, 0, 0};
  a.axis2 = {0, 20, 0};
  a.size1 = n1;
  a.size2 = n2;
  return a;
}

TEST(AreaLight, SamplesWeighAsTheReferenceHalvesTheGrid) {  // case 15
  EXPECT_NEAR(half_hidden(grid(3, 3), -.05), .75, 3e-5);
  EXPECT_NEAR(half_hidden(grid(5, 1), -.35), .875, 3e-5);
  EXPECT_NEAR(half_hidden(grid(5, 1), -.1), .625, 3e-5);
  EXPECT_NEAR(half_hidden(grid(5, 1), .1), .375, 3e-5);
  EXPECT_NEAR(half_hidden(grid(4, 4), .25), .25, 3e-5);
  AreaLight adaptive = grid(5, 5);
  adaptive.adaptive = 0;
  EXPECT_NEAR(half_hidden(adaptive, -.35), .875, 3e-5);
  AreaLight round = grid(5, 5);
  round.circular = true;
  EXPECT_NEAR(half_hidden(round, .4), .09375, 3e-5);
  AreaLight fine = grid(17, 1);
  fine.adaptive = 1;
  EXPECT_NEAR(half_hidden(fine, .3), .21875, 3e-5);
}

TEST(AreaLight, IlluminationComesFromEverySample) {  // case 15b
  AreaLight a = grid(3, 3);
  a.axis1 = {200, 0, 0};
  a.axis2 = {0, 200, 0};
  a.illumination = true;
  const auto lamp = light({0, 0, -100}, Rgb(1.0f), [&](LightSource& l) { l.area = a; });
  expect_grey(look(scene({lamp, wall(white_diffuse())}), camera()), .68199f);
}

Color behind(const MutableObject& hidden) {
  hidden->no_image = true;
  return look(scene({sun(), hidden, wall(white_diffuse())}), camera());
}

TEST(Shadow, EverySurfaceFiltersTheLight) {  // case 16
  const auto tinted = texture(rgbft(1, .5f, .25f, .5f, .2f), finish(0, 0));
  expect_rgb(behind(object(plane({0, 0, 1}, -1), tinted)), .7f, .45f, .325f);
  expect_rgb(behind(object(sphere({0, 0, -3}, 1), tinted)), .49f, .2025f, .10562f);
}

TEST(Shadow, InteriorFadesTheLight) {  // case 16
  const auto clear = texture(rgbt(1, 1), finish(0, 0));
  for (const auto& [power, r, g, b] : {std::array{2.0f, 1.0f, .6f, .2f}, std::array{1000.0f, 1.0f, .36788f, .13533f}}) {
    auto ball = object(sphere({0, 0, -3}, 1), clear);
    auto inside = interior();
    inside->fade_distance = 1;
    inside->fade_power = power;
    inside->fade_color = Rgb(1, .5f, 0);
    ball->interior = inside;
    expect_rgb(behind(ball), r, g, b);
  }
}

TEST(Shadow, FakedCausticsBrighten) {  // case 34
  auto ball = object(sphere({0, 0, -3}, 1), texture(rgbft(1, 1, 1, .5f), finish([](Finish& f) { f.caustics = .1f; })));
  ball->no_image = true;
  const auto lamp = light({0, 0, -100}, Rgb(.1f));
  expect_grey(look(scene({lamp, ball, wall(white_diffuse())}), camera()), .1f);
}

TEST(Shadow, NoShadowOfPartsDependsOnTheCombination) {  // case 25
  const auto combined = [](CsgOperation operation, bool split) {
    auto ball = object(sphere({0, 0, -3}, 1), texture(rgbft(1, 1, 1), finish(0, 0)));
    ball->no_shadow = true;
    auto other = object(sphere({9, 9, -3}, 1), texture(rgbft(1, 1, 1), finish(0, 0)));
    auto u = csg(operation, {ball, other});
    std::get<Csg>(u->geometry).split_union = split;
    u->no_image = true;
    return look(scene({sun(), u, wall(white_diffuse())}), camera()).rgb.r;
  };
  EXPECT_NEAR(combined(CsgOperation::kUnion, true), 1, 3e-5);
  EXPECT_NEAR(combined(CsgOperation::kUnion, false), 0, 3e-5);
  EXPECT_NEAR(combined(CsgOperation::kMerge, true), 0, 3e-5);
}

TEST(LightGroup, LightsItsMembersOnly) {  // §10.5
  auto member = wall(white_diffuse());
  auto group = csg(CsgOperation::kLightGroup, {light({0, 0, -100}, Rgb(.25f)), member});
  expect_grey(look(scene({sun(), group}), camera()), .25f);
  group->global_lights = true;
  expect_grey(look(scene({sun(), group}), camera()), 1.25f);
  auto outside = csg(CsgOperation::kLightGroup, {light({0, 0, -100}, Rgb(.25f))});
  expect_grey(look(scene({sun(), outside, wall(white_diffuse())}), camera()), 1);
}

TEST(LightGroup, InnerGroupsSeeTheLightsOfOuterOnes) {  // §10.5
  auto inner = csg(CsgOperation::kLightGroup, {wall(white_diffuse()), light({0, 0, -100}, Rgb(.5f))});
  auto outer = csg(CsgOperation::kLightGroup, {inner, light({0, 0, -100}, Rgb(.125f))});
  expect_grey(look(scene({outer}), camera()), .625f);
}

TEST(ProjectedLight, ShinesThroughItsObjectOnly) {  // §11.5
  const auto through = [](dvec3 center) {
    return light({0, 0, -100}, Rgb(1.0f), [&](LightSource& l) { l.projected_through = object(sphere(center, 1)); });
  };
  EXPECT_NEAR(lit_at(through({0, 0, -20}), {0, 0, 0}), 1, 3e-5);
  EXPECT_NEAR(lit_at(through({9, 0, -20}), {0, 0, 0}), 0, 3e-5);
}

}  // namespace
}  // namespace lute::testing
