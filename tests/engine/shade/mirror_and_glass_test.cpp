// Check cases of specification chapter 40 §19: reflection, refraction, interiors, trace levels.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

template <class Set>
FinishPtr mirror(float low, float high, Set&& set) {
  return finish([&](Finish& f) {
    f.reflection_min = Rgb(low);
    f.reflection_max = Rgb(high);
    set(f);
  });
}
FinishPtr mirror(float low, float high) {
  return mirror(low, high, [](Finish&) {});
}
void fresnel(Finish& f) { f.reflection_fresnel = true; }

std::shared_ptr<Interior> glass(float ior) {
  auto i = interior();
  i->ior = ior;
  return i;
}

Color seen_in(const FinishPtr& f, double angle, InteriorPtr inside = nullptr, Color color = rgbft(0, 0, 0)) {
  auto w = wall(texture(color, f));
  w->interior = std::move(inside);
  return look(with_background(scene({w}), kBlueSky), camera(angle));
}

TEST(Mirror, AmountRunsFromMinToMax) {  // case 7
  expect_rgb(seen_in(mirror(0, 1), 60), .1f, .2f, .4f);
  expect_rgb(seen_in(mirror(.1f, 1, [](Finish& f) { f.reflection_falloff = 2; }), 60), .065f, .13f, .26f);
  expect_rgb(seen_in(mirror(0, 1, fresnel), 60, glass(1.5f)), .01784f, .03568f, .07135f);
  expect_rgb(seen_in(mirror(.1f, .8f, fresnel), 60, glass(1.5f)), .03249f, .06497f, .12995f);
}

TEST(Mirror, ExponentIsAppliedToTheReflectedColor) {  // case 8
  expect_rgb(seen_in(mirror(1, 1, [](Finish& f) { f.reflection_exponent = .5f; }), 0), .44721f, .63246f, .89442f);
}

TEST(Mirror, MetallicReflectionLosesItsTintWhenGrazing) {  // case 9
  const auto metal = mirror(1, 1, [](Finish& f) { f.reflection_metallic = 1; });
  expect_rgb(seen_in(metal, 75, nullptr, rgbft(1, .5f, .25f)), .2f, .23313f, .2994f);
}

TEST(Mirror, ConserveEnergyTakesReflectedLightFromWhatPasses) {  // case 10
  expect_rgb(seen_in(mirror(.25f, .25f), 0, nullptr, rgbt(1, 1)), .25f, .5f, 1);
  const auto conserving = mirror(.25f, .25f, [](Finish& f) { f.conserve_energy = true; });
  expect_rgb(seen_in(conserving, 0, nullptr, rgbt(1, 1)), .2f, .4f, .8f);
}

TEST(TraceLevel, EndsFacingMirrors) {  // case 11
  const auto with_ambient = [](float a) { return mirror(1, 1, [=](Finish& f) { f.ambient = Rgb(a); }); };
  Scene s = scene({object(plane({0, 0, 1}, 0), texture(rgbft(1, 1, 1), with_ambient(.1f))),
                   object(plane({0, 0, -1}, 6), texture(rgbft(1, 1, 1), with_ambient(.01f)))});
  s.settings.max_trace_level = 5;
  expect_grey(look(s, camera()), .32f);
  s.settings.max_trace_level = 2;
  expect_grey(look(s, camera()), .11f);
}

Scene nested_glass(int count, float step) {
  Scene s = with_background(scene({}), kBlueSky);
  for (int i = 0; i < count; ++i) {
    auto p = object(plane({0, 0, -1}, -i), texture(rgbt(1, 1), finish(0, 0)));
    p->interior = glass(1.1f + step * static_cast<float>(i));
    s.objects.push_back(p);
  }
  return s;
}

TEST(TraceLevel, CountsBentRaysOnly) {  // case 12
  expect_rgb(look(nested_glass(4, .1f), camera()), .2f, .4f, .8f);
  expect_rgb(look(nested_glass(5, .1f), camera()), 0, 0, 0);
  expect_rgb(look(nested_glass(5, 0), camera()), .2f, .4f, .8f);
}

TEST(TraceLevel, DoesNotCountStraightRaysButEndsThem) {  // §3.1
  Scene s = with_background(scene({}), kBlueSky);
  for (int i = 0; i < 50; ++i) s.objects.push_back(object(plane({0, 0, -1}, -i), texture(rgbt(1, 1), finish(0, 0))));
  expect_rgb(look(s, camera()), .2f, .4f, .8f);
  s.settings.max_trace_level = 1;
  expect_rgb(look(s, camera()), 0, 0, 0);
}

Color through_box(InteriorPtr inside) {
  auto b = object(box({-1, -1, -1}, {1, 1, 1}), texture(rgbt(1, 1), finish(0, 0)));
  b->interior = std::move(inside);
  return look(with_background(scene({b}), kBlueSky), camera());
}

TEST(Glass, FadesByDistance) {  // case 17
  auto fade = interior();
  fade->fade_distance = 1;
  fade->fade_color = Rgb(1, .5f, 0);
  fade->fade_power = 2;
  expect_rgb(through_box(fade), .2f, .24f, .16f);
  fade->fade_power = 0;
  expect_rgb(through_box(fade), .2f, .3f, .4f);
  fade->fade_power = 1001;
  expect_rgb(through_box(fade), .2f, .14716f, .10826f);
}

TEST(Glass, DispersionSplitsHeadOnLightIntoAlmostWhite) {  // case 18
  auto prism = glass(1.5f);
  prism->dispersion = 1.1f;
  expect_rgb(through_box(prism), .19876f, .4f, .79696f, 6e-5f);
}

// A sky whose brightness tells where a ray goes: 0.5 + 0.5 y of its direction.
Scene below_bright_zenith(std::vector<ObjectPtr> objects) {
  auto pigment = std::make_shared<Pigment>();
  pigment->body.pattern = AnyPattern(Gradient{});
  std::get<Gradient>(std::get<AnyPattern>(pigment->body.pattern)).direction = {0, 1, 0};
  ColorMap map;
  map.entries = {{0, rgbft(0, 0, 0)}, {1, rgbft(1, 1, 1)}};
  pigment->map = map;
  pigment->body.warps.push_back(Transform::scale({2, 2, 2}).then(Transform::translate({0, -1, 0})));
  Scene s = scene(std::move(objects));
  s.sky_sphere.emplace();
  s.sky_sphere->pigments.push_back(pigment);
  return s;
}

// Looks at the surface y = 0 of a half-space of glass below it, at `angle` degrees from the upright.
double sine_behind_surface(float ior, double angle, bool from_below) {
  auto p = object(plane({0, 1, 0}, 0), texture(rgbt(1, 1), finish(0, 0)));
  p->interior = glass(ior);
  const double up = from_below ? 1 : -1;
  const Ray ray{{0, -up, 0}, {std::sin(radians(angle)), up * std::cos(radians(angle)), 0}};
  return 2 * static_cast<double>(look(below_bright_zenith({p}), ray).rgb.r) - 1;
}

// Snell: sin(a) = n sin(b); what is seen goes down with -cos(b).
TEST(Glass, BendsRaysBySnellsLaw) {
  for (const double n : {1.1, 1.5, 2.4}) {
    for (const double angle : {0.0, 20.0, 45.0, 80.0}) {
      const double b = std::asin(std::sin(radians(angle)) / n);
      EXPECT_NEAR(sine_behind_surface(static_cast<float>(n), angle, false), -std::cos(b), 2e-5) << n << ' ' << angle;
    }
  }
  // Out of the glass, below the critical angle of 41.81 degrees.
  EXPECT_NEAR(sine_behind_surface(1.5f, 30, true), std::cos(std::asin(1.5 * .5)), 2e-5);
}

// Beyond the critical angle, asin(1 / n), all light stays inside: the ray comes back as from a mirror, whatever the finish.
TEST(Glass, ReflectsTotallyBeyondTheCriticalAngle) {
  EXPECT_NEAR(sine_behind_surface(1.5f, 60, true), -.5, 2e-5);
  const double critical = std::asin(1 / 1.5) / radians(1);
  EXPECT_NEAR(sine_behind_surface(1.5f, critical + .01, true), -std::cos(radians(critical + .01)), 2e-5);
  EXPECT_GT(sine_behind_surface(1.5f, critical - .01, true), 0);
}

TEST(Glass, DispersionBendsColorsApart) {  // case 18b
  const auto seen = [&](float dispersion, int samples) {
    auto prism = glass(1.5f);
    prism->dispersion = dispersion;
    prism->dispersion_samples = samples;
    auto p = object(plane({0, 1, -1}, 0), texture(rgbt(1, 1), finish(0, 0)));
    p->interior = prism;
    return look(below_bright_zenith({p}), camera());
  };
  expect_rgb(seen(1, 7), .35486f, .35486f, .35486f);
  expect_rgb(seen(1.2f, 7), .36498f, .3588f, .34279f);
  expect_rgb(seen(1.2f, 2), .36371f, .36056f, .34257f);
  expect_rgb(seen(1.2f, 20), .365f, .3588f, .34275f);
}

TEST(Glass, OverlappingPartsOfAUnionLeaveTheirCommonInterior) {  // case 28
  auto inside = glass(1.5f);
  inside->fade_distance = 1;
  inside->fade_power = 2;
  const auto clear = texture(rgbt(1, 1), finish(0, 0));
  auto u = csg(CsgOperation::kUnion, {object(sphere({0, 0, 0}, 1)), object(sphere({0, 0, 1.2}, 1))});
  u->texture.texture = clear;
  u->interior = inside;
  Scene s = with_background(scene({u}), kBlueSky);
  s.settings.max_trace_level = 20;
  expect_rgb(look(s, {{0, .3, -5}, {0, 0, 1}}), .03439f, .06877f, .13754f);
}

}  // namespace
}  // namespace lute::testing
