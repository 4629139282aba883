// Specification chapter 50 §16 C: a plane z = 0 seen along z in an orthographic picture of 4 by 3 pixels; the pigment is `aoi`, so that a
// pixel is the angle between the perturbed normal and the ray, over pi. Values were measured to 2e-5.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pattern_value.hpp"

namespace lute {
namespace {

using Rows = std::array<std::array<double, 4>, 3>;

SurfaceContext plane_at(const dvec3& point) {
  SurfaceContext surface;
  surface.point = point;
  surface.raw_normal = surface.normal = {0, 0, -1};
  surface.ray_direction = {0, 0, 1};
  surface.has_surface = true;
  return surface;
}

double aoi(const dvec3& normal) { return std::acos(std::clamp(glm::normalize(normal).z, -1.0, 1.0)) / kPi; }

void expect_picture(const Normal& description, const Rows& rows) {
  TextureCompiler compiler{TextureSettings()};
  const CompiledNormal* normal = compiler.normal(std::make_shared<Normal>(description), false);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      const dvec3 p{column - 1.5, 1.0 - row, 0};
      const double value = aoi(normal->perturb({0, 0, -1}, p, plane_at(p)));
      EXPECT_NEAR(value, rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], 2e-5) << row << ' ' << column;
    }
}

template <class Pattern>
Normal normal_of(const Pattern& pattern, float amount) {
  Normal normal;
  normal.body = body_of(pattern);
  normal.amount = amount;
  return normal;
}

Normal moved(Normal normal, const Transform& transform) {
  prepend_transform(normal.body.warps, transform);
  return normal;
}

Gradient gradient(const dvec3& direction) {
  Gradient g;
  g.direction = direction;
  return g;
}

TEST(Normal, Bumps) {  // C1
  expect_picture(normal_of(Bumps(), 0.5f),
                 {{{.88217, .94624, .88725, .95598}, {.96452, .95270, .96043, .94115}, {.96921, .99248, .99158, .92578}}});
}

TEST(Normal, GraniteByItsHeight) {  // C2
  expect_picture(normal_of(Granite(), 0.5f),
                 {{{.92818, .89009, .92863, .91313}, {.86566, .97784, .91444, .95142}, {.86607, .92255, .92325, .98618}}});
}

TEST(Normal, ScaledRipples) {  // C3
  expect_picture(moved(normal_of(Ripples(), 0.5f), Transform::scale(dvec3(0.5))),
                 {{{.98668, .98851, .97896, .99063}, {.97490, .96469, .94697, .93434}, {.98401, .95290, .98216, .98596}}});
}

TEST(Normal, FacetsInSpace) {  // C4
  Facets facets;
  facets.coords = 0.5f;
  facets.size = 0.3f;
  expect_picture(normal_of(facets, 0.5f),
                 {{{.90684, .97958, .95460, .94347}, {.96535, .97119, .98024, .92828}, {.96989, .95047, .96040, .97488}}});
}

TEST(Normal, SlopeMapShapesTheHeight) {  // C5
  Normal normal = normal_of(gradient({1, 0, 0}), 0.5f);
  normal.map = SlopeMap{{{0, {0, 1}}, {0.5f, {1, 0}}, {1, {0, -1}}}};
  normal = moved(moved(normal, Transform::scale(dvec3(2))), Transform::translate({0.3, 0, 0}));
  const std::array<double, 4> row = {.94592, .97014, .94592, .97014};
  expect_picture(normal, {row, row, row});
}

TEST(Normal, WithoutBumpScaleSlopesShrink) {  // C6
  Normal normal = moved(normal_of(Wrinkles(), 0.8f), Transform::scale(dvec3(2)));
  normal.no_bump_scale = true;
  expect_picture(normal, {{{.89142, .82162, .88080, .88154}, {.90434, .86630, .89534, .86954}, {.88034, .95911, .94775, .91905}}});
}

TEST(Normal, FacetsOfTheNormalAreOneFaceOnAPlane) {  // C18
  Facets facets;
  facets.size = 0.7f;
  const std::array<double, 4> row = {.88383, .88383, .88383, .88383};
  expect_picture(moved(normal_of(facets, 0.5f), Transform::scale({1, 2, 1})), {row, row, row});
}

Normal bumps_and_dents(PatternBody body, float first, float second) {
  Normal normal;
  normal.body = std::move(body);
  normal.map = NormalMap{{{first, std::make_shared<Normal>(normal_of(Bumps(), 0.6f))},
                          {second, std::make_shared<Normal>(normal_of(Dents(), 0.9f))}}};
  return moved(moved(normal, Transform::scale(dvec3(5))), Transform::translate({0, -2.5, 0}));
}

TEST(Normal, NormalMapBlendsUnitNormals) {  // C19
  expect_picture(bumps_and_dents(body_of(gradient({0, 1, 0})), 0, 1),
                 {{{.97044, .97195, .97768, .97491}, {.94693, .94591, .95599, .96457}, {.93068, .92535, .93898, .95656}}});
}

// gradient x normal_map { [0 bumps 1 no_bump_scale scale 0.1] [1 granite 1 no_bump_scale scale 0.2] } scale 5
// translate <-2.37, 0.27, 0.31>, measured with the reference: normals without bump scale are blended as long as they are.
TEST(Normal, NormalMapBlendsNormalsWithoutBumpScaleByTheirLength) {
  const auto entry = [](Normal normal, double scale) {
    normal.no_bump_scale = true;
    return std::make_shared<Normal>(moved(std::move(normal), Transform::scale(dvec3(scale))));
  };
  Normal normal;
  normal.body = body_of(gradient({1, 0, 0}));
  normal.map = NormalMap{{{0, entry(normal_of(Bumps(), 1), 0.1)}, {1, entry(normal_of(Granite(), 1), 0.2)}}};
  normal = moved(moved(normal, Transform::scale(dvec3(5))), Transform::translate({-2.37, 0.27, 0.31}));
  expect_picture(normal, {{{.67570, .59077, .17934, .86343}, {.90294, .76178, .76800, .40351}, {.50694, .35813, .80743, .68319}}});
}

// gradient x normal_map { [0 gradient y normal_map { [0 bumps 1] [1 dents 2] } scale <1, 2, 3>] [1 bumps 1] } no_bump_scale scale 5
// translate -2.37*x, measured with POV-Ray 3.7.0.10: a map gives a unit also inside of another map, after its own transformation.
TEST(Normal, MapsInsideOfMapsAreBlendedAsUnits) {
  Normal inner, outer;
  inner.body = body_of(gradient({0, 1, 0}));
  inner.map = NormalMap{{{0, std::make_shared<Normal>(normal_of(Bumps(), 1))}, {1, std::make_shared<Normal>(normal_of(Dents(), 2))}}};
  inner = moved(inner, Transform::scale({1, 2, 3}));
  outer.body = body_of(gradient({1, 0, 0}));
  outer.map = NormalMap{{{0, std::make_shared<Normal>(inner)}, {1, std::make_shared<Normal>(normal_of(Bumps(), 1))}}};
  outer.no_bump_scale = true;
  outer = moved(moved(outer, Transform::scale(dvec3(5))), Transform::translate({-2.37, 0, 0}));
  expect_picture(outer, {{{.97527, .98151, .97815, .97588}, {.97856, .98570, .98077, .97646}, {.99202, .99554, .98680, .98181}}});
}

TEST(Normal, FacetsOfMetricOneTakeTheSumWithoutMagnitudes) {  // facets coords 0.5 size 0.25 metric 1, measured with the reference
  Facets facets;
  facets.coords = 0.5f;
  facets.size = 0.25f;
  facets.metric = 1;
  expect_picture(normal_of(facets, 0.5f), {{{.91572, .97560, .93863, .92966}, {.97194, .97853, .97388, .93138}, {.94495, .94154, .93646, .96933}}});
}

TEST(Normal, AverageWeighsUnitNormals) {  // C21
  PatternBody body;
  body.pattern = Average{};
  expect_picture(bumps_and_dents(body, 1, 2),
                 {{{.96741, .96909, .97562, .97279}, {.96425, .96373, .96992, .97511}, {.96626, .96405, .96968, .97739}}});
}

TEST(Normal, CheckerWithoutListIsAHeight) {  // C22
  expect_picture(normal_of(Checker(), 0.5f),
                 {{{.34986, .81184, .34986, .81184}, {.81184, .34986, .81184, .34986}, {.34986, .81184, .34986, .81184}}});
}

// C20: inside of a texture_map, slope and aoi see the normal in the enclosing texture's space: the layer's normal is carried in by
// the enclosing texture first. Red is 1 - t of the way from aoi to 1.
TEST(Normal, EnclosingTextureCarriesTheNormalIn) {
  PatternBody body = body_of(gradient({1, 0, 0}));
  prepend_transform(body.warps, Transform::scale({4, 2, 1}));
  prepend_transform(body.warps, Transform::translate({-2, 0, 0}));
  TextureCompiler compiler{TextureSettings()};
  const CompiledPattern outer(body, compiler);
  const CompiledNormal* bumps = compiler.normal(std::make_shared<Normal>(normal_of(Bumps(), 0.5f)), false);
  const Rows rows = {{{.9379, .9638, .9752, .9934}, {.9493, .9795, .9814, .9935}, {.9773, .9724, .9869, .9974}}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      const dvec3 p{column - 1.5, 1.0 - row, 0};
      const SurfaceContext surface = plane_at(p);
      const dvec3 warped = outer.warp(p);
      const double t = outer.value(warped, surface);
      const dvec3 n = bumps->perturb(outer.carry_in({0, 0, -1}, true), warped, surface);
      EXPECT_NEAR((1 - t) * aoi(n) + t, rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], 1e-4);
    }
}

}  // namespace
}  // namespace lute
