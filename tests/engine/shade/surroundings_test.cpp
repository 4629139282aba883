// Check cases of specification chapter 40 §19: background, sky sphere, fog, rainbow, alpha, visibility.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

TEST(SkySphere, LayersComposeOverTheBackground) {  // case 19
  Scene s = with_background(scene({}), rgbft(.1f, .2f, .3f));
  s.sky_sphere.emplace();
  s.sky_sphere->pigments = {pigment(rgbft(1, 0, 0, .2f, .3f)), pigment(rgbft(.5f, 1, 0, .3f, .5f))};
  expect_rgb(look(s, camera()), .4575f, .248f, .045f);
  expect_rgb(look(before_version_37(s), camera()), .518f, .23f, .045f);
}

TEST(Background, AlphaIsWhatTheSurfaceKeeps) {  // case 31; the picture's colours are these divided by alpha
  BuildOptions options;
  options.output_alpha = true;
  const auto t = texture(rgbft(1, .5f, .25f, .5f, .2f), finish(1, 0));
  const Scene s = with_background(scene({wall(t)}), rgbft(.4f, .8f, .4f, .3f, .5f));
  const Color now = look(s, camera(), options);
  EXPECT_NEAR(1 - now.transmit, .64776, 3e-5);
  expect_rgb(now, .5496f * .64776f, .34272f * .64776f, .15592f * .64776f);
  const Color legacy = look(before_version_37(s), camera(), options);
  EXPECT_NEAR(1 - legacy.transmit, .49, 3e-5);
  expect_rgb(legacy, .61224f * .49f, .30613f * .49f, .15306f * .49f);
}

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

TEST(Fog, MixesItsColorByDistance) {  // case 20
  const auto white = slab(finish(1, 0));
  expect_rgb(through({fog(10, rgbft(.5f, .25f, 0))}, {white}), .80327f, .70489f, .60653f);
  expect_rgb(through({fog(10, rgbft(.5f, .25f, 0, .5f, .1f))}, {white}), .65164f, .47745f, .30326f);
  expect_rgb(through({fog(10, rgbft(.5f, .25f, 0, 0, .7f))}, {white}), .85f, .775f, .7f);
  expect_rgb(through({fog(10, rgbft(1, 0, 0)), fog(20, rgbft(0, 1, 0))}, {white}), .86584f, .69357f, .47237f);
}

TEST(Fog, GroundFogThinsOutUpward) {  // case 21
  Fog ground = fog(1, rgbft(0, .5f, 1));
  ground.type = 2;
  ground.altitude = ground.offset = .5;
  const auto white = texture(rgbft(1, 1, 1), finish(1, 0));
  Scene up = scene({object(box({-9, 2, -9}, {9, 3, 9}), white)});
  up.fogs = {ground};
  expect_rgb(look(up, {{0, 0, 0}, {0, 1, 0}}), .3248f, .66241f, 1);
  Scene along = scene({object(box({-9, -9, 2}, {9, 9, 3}), white)});
  along.fogs = {ground};
  expect_rgb(look(along, {{0, 1, 0}, {0, 0, 1}}), .36788f, .68394f, 1);
}

TEST(Fog, DimsLightOnItsWayWhereTheLightAsks) {  // case 22
  const auto lamp = [](bool attenuation, bool interaction) {
    return light({0, 0, 0}, Rgb(1.0f), [=](LightSource& l) {
      l.media_attenuation = attenuation;
      l.media_interaction = interaction;
    });
  };
  const auto seen = [&](const MutableObject& l) { return through({fog(10, rgbft(0, 0, 0))}, {l, slab(finish(0, 1))}); };
  expect_grey(seen(lamp(false, true)), .60653f);
  expect_grey(seen(lamp(true, true)), .36788f);
  expect_grey(seen(lamp(true, false)), .60653f);
}

TEST(Fog, VanishesInsideWhatIsNotHollow) {  // §3: a camera below a plane
  auto ground = object(plane({0, 1, 0}, 10), texture(rgbft(1, 1, 1), finish(1, 0)));
  expect_grey(through({fog(10, rgbft(0, 0, 0))}, {slab(finish(1, 0)), ground}), 1);
  ground->hollow = true;
  expect_grey(through({fog(10, rgbft(0, 0, 0))}, {slab(finish(1, 0)), ground}), .60653f);
}

TEST(Rainbow, MixesItsColorsByAngle) {  // case 23
  Rainbow bow;
  bow.angle = 30;
  bow.width = 20;
  bow.distance = 100;
  bow.direction = {0, 0, 1};
  bow.colors.entries = {{0, rgbft(1, .5f, .25f, .3f, .2f)}, {1, rgbft(1, .5f, .25f, .3f, .2f)}};
  auto shell = object(sphere({0, 0, 0}, 50), texture(rgbft(.1f, .2f, .3f), finish(1, 0)));
  shell->hollow = true;
  Scene s = scene({shell});
  s.rainbows = {bow};
  expect_rgb(look(s, {{0, 0, 0}, {0, std::sin(radians(30)), std::cos(radians(30))}}), .45412f, .31089f, .26423f);
}

Color combined(CsgOperation operation, bool split) {
  auto ball = object(sphere({0, 0, 0}, 1), texture(rgbft(1, 1, 1), finish(1, 0)));
  ball->no_image = true;
  std::vector<ObjectPtr> parts{ball};
  if (operation == CsgOperation::kIntersection)
    parts.push_back(object(sphere({0, 0, 0}, 2), texture(rgbft(1, 1, 1), finish(1, 0))));
  else
    parts.push_back(object(sphere({9, 9, 0}, 1), texture(rgbft(1, 1, 1), finish(1, 0))));
  auto u = csg(operation, parts);
  std::get<Csg>(u->geometry).split_union = split;
  return look(with_background(scene({u}), kBlueSky), camera());
}

TEST(Visibility, NoImageOfPartsDependsOnTheCombination) {  // case 24
  expect_rgb(combined(CsgOperation::kUnion, true), .2f, .4f, .8f);
  expect_grey(combined(CsgOperation::kUnion, false), 1);
  expect_rgb(combined(CsgOperation::kMerge, true), .2f, .4f, .8f);
  expect_grey(combined(CsgOperation::kIntersection, true), 1);
}

}  // namespace
}  // namespace lute::testing
