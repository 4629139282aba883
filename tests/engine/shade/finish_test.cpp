// Check cases of specification chapter 40 §19: ambient, diffuse, highlights, layers, iridescence.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

const Color kOrange = rgbft(1, 0.5f, 0.25f);

TEST(Finish, DiffuseFollowsBrilliance) {  // case 1
  const auto lamp = light({0, 1000, -1000});
  const auto brilliant = [](float diffuse) {
    return finish([=](Finish& f) {
      f.diffuse = diffuse;
      f.brilliance = 3;
    });
  };
  expect_rgb(look(scene({lamp, wall(texture(kOrange, finish(0, 0.8f)))}), camera()), .56568f, .28284f, .14142f);
  expect_rgb(look(scene({lamp, wall(texture(kOrange, brilliant(0.8f)))}), camera()), .28284f, .14142f, .07071f);
  expect_rgb(look(scene({lamp, wall(texture(kOrange, brilliant(0.8f * 2)))}), camera()), .56568f, .28284f, .14142f);
}

TEST(Finish, HighlightsAreThoseOfTheReference) {  // case 1b
  const auto lamp = light({0, 1000, -1000});
  const auto seen = [&](auto set) { return look(scene({lamp, wall(texture(kOrange, finish(set)))}), camera()); };
  const auto phong = [](Finish& f) { f.phong = .5f, f.phong_size = 3; };
  const auto specular = [](Finish& f) { f.specular = .5f, f.specular_exponent = 10; };
  const auto metal = [](Finish& f) { f.specular = .5f, f.specular_exponent = 10, f.metallic = 1; };
  expect_grey(seen(phong), .17678f);
  expect_grey(seen(specular), .22654f);
  expect_rgb(seen(metal), .22654f, .11624f, .06110f);
}

TEST(Finish, MetallicHighlightTurnsWhiteAtGrazingAngles) {  // case 2
  const auto lamp = light(dvec3(0, std::sin(radians(75)), -std::cos(radians(75))) * 1000.0);
  const auto metal = finish([](Finish& f) { f.specular = .5f, f.specular_exponent = 1, f.metallic = 1; });
  expect_rgb(look(scene({lamp, wall(texture(kOrange, metal))}), camera()), .39667f, .23119f, .14846f);
}

TEST(Layers, OpacityScalesOwnLightAndFilterWhatIsBehind) {  // cases 3, 3b
  const auto t = texture(rgbft(1, .5f, .25f, .5f, .2f), finish(.1f, .8f));
  expect_rgb(look(with_background(scene({sun(), wall(t)}), rgbft(.2f, .3f, .4f)), camera()), .41f, .27f, .1975f);
  const auto u = texture(rgbft(.8f, .5f, .25f, .5f, .2f), finish(.1f, .8f));
  const Scene dark = with_background(scene({sun(), wall(u)}), rgbft(0, 0, 0));
  expect_rgb(look(dark, camera()), .216f, .135f, .0675f);
  expect_rgb(look(before_version_37(dark), camera()), .288f, .18f, .09f);
}

TEST(Layers, UpperFilterTintsLowerLight) {  // case 4
  const auto t = texture({{rgbft(1, 1, 0), finish(0, .8f)}, {rgbft(1, .5f, .25f, .5f, .2f), finish(0, .6f)}});
  expect_rgb(look(scene({sun(), wall(t)}), camera()), .74f, .45f, .045f);
}

TEST(Layers, HighlightOfLowerLayerIsFilteredOnly) {  // case 33
  const auto shiny = finish([](Finish& f) { f.phong = .5f; });
  const auto t = texture({{rgbft(0, 0, 0), shiny}, {rgbft(1, .5f, .25f, .5f), finish(0, 0)}});
  expect_rgb(look(scene({light({0, 0, -1000}), wall(t)}), camera()), .25f, .125f, .0625f);
}

TEST(Layers, NothingIsSeenBelowAnOpaqueLayer) {  // case 32
  const auto mirror = finish([](Finish& f) { f.reflection_min = f.reflection_max = Rgb(.5f); });
  const auto t = texture({{rgbft(1, 1, 1), mirror}, {rgbft(0, 0, 0), finish(0, 0)}});
  expect_grey(look(with_background(scene({sun(), wall(t)}), kBlueSky), camera()), 0);
}

TEST(Finish, IridescenceInterferesByThickness) {  // case 6
  const auto film = finish([](Finish& f) { f.diffuse = .5f, f.irid = .4f, f.irid_thickness = .1f; });
  expect_rgb(look(scene({sun(), wall(texture(rgbft(1, 1, 1), film))}), camera()), .4555f, .3503f, .3268f);
}

TEST(Finish, CrandOnlyDarkens) {  // §7 step 7: i - u * crand, u in 0...1; the stream of u is our own
  const auto grainy = finish([](Finish& f) { f.diffuse = .5f, f.crand = .4f; });
  const Color seen = look(scene({sun(), wall(texture(rgbft(1, 1, 1), grainy))}), camera());
  EXPECT_LE(seen.rgb.r, .5f);
  EXPECT_GE(seen.rgb.r, .1f);
}

TEST(Finish, LightFromBehindNeedsDoubleIlluminateOrBackDiffuse) {  // case 26
  const auto lamp = light({0, 0, 100});
  const auto a0 = texture(rgbft(1, 1, 1), finish(0, 1));
  expect_grey(look(scene({lamp, wall(a0)}), camera()), 0);
  auto both = object(plane({0, 0, -1}, 0), a0);
  both->double_illuminate = true;
  auto no_shadow = both;
  no_shadow->no_shadow = true;
  expect_grey(look(scene({lamp, no_shadow}), camera()), 1);
  auto back = wall(texture(rgbft(1, 1, 1), finish([](Finish& f) { f.diffuse = .3f, f.diffuse_back = .4f; })));
  expect_grey(look(scene({lamp, back}), camera()), .4f);
}

TEST(Quality, EachLevelAddsItsTerms) {  // case 27
  auto quick = std::make_shared<Pigment>();
  quick->map = kOrange;
  auto t = std::make_shared<Texture>();
  t->content = std::vector<TextureLayer>{{quick, nullptr, finish(.1f, .5f)}};
  auto blocker = object(box({-1, -1, -12}, {1, 1, -11}), texture(rgbft(1, 1, 1), finish(0, 1)));
  BuildOptions options;
  options.quality = 1;
  expect_rgb(look(scene({sun(), wall(t)}), camera(), options), 1, .5f, .25f);
  options.quality = 3;
  expect_rgb(look(scene({sun(), wall(t), blocker}), camera(), options), .6f, .3f, .15f);
  options.quality = 4;
  expect_rgb(look(scene({sun(), wall(t), blocker}), camera(), options), .1f, .05f, .025f);
  quick->quick_color = rgbft(0, 1, 0);
  options.quality = 5;
  expect_rgb(look(scene({sun(), wall(t)}), camera(), options), 0, .6f, 0);
}

}  // namespace
}  // namespace lute::testing
