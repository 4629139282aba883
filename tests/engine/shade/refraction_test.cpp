// Snell's law and total reflection in numbers worked out by hand.
#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

std::shared_ptr<Interior> glass(float ior) {
  auto i = interior();
  i->ior = ior;
  return i;
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
  p->extras.edit().interior = glass(ior);
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

}  // namespace
}  // namespace lute::testing
