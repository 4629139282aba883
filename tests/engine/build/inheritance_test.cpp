// What objects pass to their parts. Source: specification chapters 11 §14.1 and 20 §6, §8.
#include "tests/engine/shade/test_scene.hpp"

#include <functional>

#include "engine/build/geometry_answers.hpp"
#include "engine/csg/csg_solid.hpp"

namespace lute::testing {
namespace {

TexturePtr glowing(float r, float g, float b) { return texture(rgbft(r, g, b), finish(1, 0)); }

MutableObject ball(TexturePtr t = nullptr) { return object(sphere({0, 0, 0}, 1), std::move(t)); }
MutableObject far_ball(TexturePtr t = nullptr) { return object(sphere({50, 0, 0}, 1), std::move(t)); }

TEST(Inheritance, PartsWithoutTextureTakeTheParents) {
  auto u = csg(CsgOperation::kUnion, {ball(), far_ball(glowing(0, 1, 0))});
  u->texture.texture = glowing(1, 0, 0);
  expect_rgb(look(scene({u}), camera()), 1, 0, 0);
  auto v = csg(CsgOperation::kUnion, {ball(glowing(0, 1, 0)), far_ball()});
  v->texture.texture = glowing(1, 0, 0);
  expect_rgb(look(scene({v}), camera()), 0, 1, 0);
}

TEST(Inheritance, WithoutAnyTextureTheDefaultOfTheStatementCounts) {
  auto u = csg(CsgOperation::kUnion, {ball(), far_ball(glowing(0, 1, 0))});
  u->extras.edit().default_texture = glowing(0, 0, 1);
  expect_rgb(look(scene({u}), camera()), 0, 0, 1);
}

TEST(Inheritance, TexturesMoveWithTheParents) {
  auto p = std::make_shared<Pigment>();
  Gradient gradient;
  gradient.direction = {0, 0, 1};
  p->body.pattern = AnyPattern(gradient);
  ColorMap map;
  map.entries = {{0, rgbft(0, 0, 0)}, {1, rgbft(1, 1, 1)}};
  p->map = map;
  auto t = std::make_shared<Texture>();
  t->content = std::vector<TextureLayer>{{p, nullptr, finish(1, 0)}};
  auto w = wall(t);
  w->transform = Transform::translate({0, 0, -0.25});
  auto fixed = csg(CsgOperation::kMerge, {w, far_ball()});
  fixed->transform = Transform::translate({0, 0, -0.5});
  // Without placement the texture was given after the wall's own move, but before the parent's: z = -0.75 shows -0.25, that is 0.75.
  expect_grey(look(scene({fixed}), camera()), 0.75f);
  w->texture.placement = w->transform;
  expect_grey(look(scene({fixed}), camera()), 0);
}

TEST(Interior, TheLastPartDecidesWhetherACommonInteriorIsHollow) {  // chapter 20 §8.2, check 18
  const auto hollow_last = [](bool last) {
    auto a = ball(), b = far_ball();
    (last ? b : a)->hollow = true;
    const auto built = built_scene(scene({csg(CsgOperation::kMerge, {a, b})}));
    std::vector<const Leaf*> leaves;
    built->solids.front()->leaves(leaves);
    EXPECT_EQ(leaves[0]->interior, leaves[1]->interior);
    return leaves[0]->interior->hollow;
  };
  EXPECT_TRUE(hollow_last(true));
  EXPECT_FALSE(hollow_last(false));
}

TEST(Interior, HollowOfAUnionReachesPartsThatDoNotSay) {
  auto a = ball(), b = far_ball();
  b->hollow = false;
  a->extras.edit().interior = interior();
  b->extras.edit().interior = interior();
  auto u = csg(CsgOperation::kMerge, {a, b});
  u->hollow = true;
  const auto built = built_scene(scene({u}));
  std::vector<const Leaf*> leaves;
  built->solids.front()->leaves(leaves);
  EXPECT_TRUE(leaves[0]->interior->hollow);
  EXPECT_FALSE(leaves[1]->interior->hollow);
}

TEST(Interior, OldFinishFormsReachIt) {  // chapter 11 §11.2
  auto b = ball(texture(rgbft(1, 1, 1), finish([](Finish& f) { f.ior = 1.5f, f.refraction = .5f; })));
  const auto built = built_scene(scene({b}));
  std::vector<const Leaf*> leaves;
  built->solids.front()->leaves(leaves);
  EXPECT_FLOAT_EQ(leaves[0]->interior->properties->ior, 1.5f);
  EXPECT_FLOAT_EQ(leaves[0]->interior->properties->refraction, .5f);
}

TEST(Union, DissolvesIntoTopLevelObjects) {  // chapter 20 §6.6
  auto inner = csg(CsgOperation::kUnion, {ball(), far_ball()});
  auto u = csg(CsgOperation::kUnion, {inner, ball()});
  EXPECT_EQ(built_scene(scene({u}))->solids.size(), 3u);
  u->edit_csg()->split_union = false;
  EXPECT_EQ(built_scene(scene({u}))->solids.size(), 1u);
  auto inverse = csg(CsgOperation::kUnion, {ball(), far_ball()});
  inverse->inverse = true;
  const auto built = built_scene(scene({inverse}));
  ASSERT_EQ(built->solids.size(), 1u);
  EXPECT_EQ(dynamic_cast<const CsgSolid&>(*built->solids[0]).kind(), CsgKind::kIntersection);
}

TEST(Difference, CuttersArriveInverted) {  // chapter 20 §6.3
  auto cutter = csg(CsgOperation::kIntersection, {object(sphere({0, 0, -1}, 1)), object(sphere({0, .1, -1}, 1))});
  auto d = csg(CsgOperation::kDifference, {object(sphere({0, 0, 0}, 1), glowing(1, 0, 0)), cutter});
  const auto built = built_scene(scene({d}));
  const auto& solid = dynamic_cast<const CsgSolid&>(*built->solids[0]);
  EXPECT_EQ(solid.kind(), CsgKind::kDifference);
  EXPECT_EQ(dynamic_cast<const CsgSolid&>(*solid.children()[1]).kind(), CsgKind::kMerge);
  EXPECT_FALSE(solid.inside({0, 0, -.5}));
  EXPECT_TRUE(solid.inside({0, 0, .5}));
}

TEST(Intersection, TakesInThePartsOfAnIntersectionInside) {
  const auto parts = [](const std::function<void(Object&)>& change) {
    auto inner = csg(CsgOperation::kIntersection, {ball(), object(sphere({0, .1, 0}, 1))});
    change(*inner);
    const auto built = built_scene(scene({csg(CsgOperation::kDifference, {inner, far_ball(), far_ball()})}));
    return dynamic_cast<const CsgSolid&>(*built->solids[0]).children().size();
  };
  EXPECT_EQ(parts([](Object&) {}), 4u);
  EXPECT_EQ(parts([](Object& o) { o.inverse = true; }), 3u);  // a merge
  EXPECT_EQ(parts([](Object& o) { o.extras.edit().clipped_by = {object(plane({1, 0, 0}, 0))}; }), 3u);
  EXPECT_EQ(parts([](Object& o) { o.edit_csg()->cutaway_textures = true; }), 3u);
}

// In POV-Ray's picture the ball stays whole: of no members, all have the point inside.
TEST(Intersection, WithNothingButALightInsideIsWhole) {
  auto lights = csg(CsgOperation::kIntersection, {light({0, 0, -10})});
  EXPECT_TRUE(built_scene(scene({csg(CsgOperation::kIntersection, {ball(), lights})}))->solids[0]->inside({0, 0, 0}));
  lights->extras.edit().clipped_by = {object(plane({0, 1, 0}, 0))};
  const auto clipped = built_scene(scene({csg(CsgOperation::kIntersection, {ball(), lights})}));
  EXPECT_TRUE(clipped->solids[0]->inside({0, -.5, 0}));
  EXPECT_FALSE(clipped->solids[0]->inside({0, .5, 0}));
}

// So POV-Ray's pictures have it: what a light looks like is a member of the intersection or difference around it, and clips.
TEST(Light, CountsAsWhatItLooksLike) {
  const auto lamp = [] {
    auto result = light({1, 0, 0});
    result->edit_light()->looks_like = object(sphere({1, 0, 0}, 1));
    return result;
  };
  const dvec3 in_both(.5, 0, 0), in_ball(-.5, 0, 0), in_lamp(1.5, 0, 0);
  const auto both = built_scene(scene({csg(CsgOperation::kIntersection, {ball(), lamp()})}));
  ASSERT_EQ(both->solids.size(), 1u);
  EXPECT_EQ(both->lights.size(), 1u);
  EXPECT_TRUE(both->solids[0]->inside(in_both));
  EXPECT_FALSE(both->solids[0]->inside(in_ball));
  EXPECT_FALSE(both->solids[0]->inside(in_lamp));
  const auto without = built_scene(scene({csg(CsgOperation::kDifference, {ball(), lamp()})}));
  ASSERT_EQ(without->solids.size(), 1u);
  EXPECT_FALSE(without->solids[0]->inside(in_both));
  EXPECT_TRUE(without->solids[0]->inside(in_ball));
  auto b = ball();
  b->extras.edit().clipped_by = {lamp()};
  const auto clipped = built_scene(scene({b}));
  EXPECT_TRUE(clipped->solids[0]->inside(in_both));
  EXPECT_FALSE(clipped->solids[0]->inside(in_ball));
}

// As POV-Ray's pictures of them: no point is inside of a union of nothing, every point inside of an intersection of nothing.
TEST(Combination, OfNothingCountsAsAMember) {
  const auto holds = [](CsgOperation outer, CsgOperation inner, bool nothing_first) {
    std::vector<ObjectPtr> members{ball(), csg(inner, {})};
    if (nothing_first) std::swap(members[0], members[1]);
    return built_scene(scene({csg(outer, members)}))->solids[0]->inside({0, 0, 0});
  };
  EXPECT_FALSE(holds(CsgOperation::kIntersection, CsgOperation::kUnion, false));
  EXPECT_FALSE(holds(CsgOperation::kIntersection, CsgOperation::kMerge, true));
  EXPECT_FALSE(holds(CsgOperation::kDifference, CsgOperation::kIntersection, false));
  EXPECT_TRUE(holds(CsgOperation::kDifference, CsgOperation::kUnion, false));
  EXPECT_FALSE(holds(CsgOperation::kDifference, CsgOperation::kUnion, true));
  EXPECT_TRUE(holds(CsgOperation::kMerge, CsgOperation::kIntersection, false));
}

TEST(Clip, StaysWhereItIsWhenTheObjectMovesBeforeIt) {
  auto b = ball(glowing(1, 0, 0));
  b->transform = Transform::translate({5, 0, 0});
  b->extras.edit().clipped_by = {object(plane({1, 0, 0}, 5))};
  const auto built = built_scene(scene({b}));
  EXPECT_TRUE(built->solids[0]->inside({4.5, 0, 0}));
  EXPECT_FALSE(built->solids[0]->inside({5.5, 0, 0}));
}

TEST(Bounds, BoxOfADiscardedBoundCutsOnceTheHierarchyIsInUse) {  // chapter 20 §7.3, check 11
  const auto seen = [](int objects) {
    auto b = object(sphere({0, 0, 0}, 1.5), glowing(1, 0, 0));
    b->extras.edit().bounded_by = {object(box({-.5, -.5, -2}, {.5, .5, 2}))};
    std::vector<ObjectPtr> all{b};
    while (static_cast<int>(all.size()) < objects) all.push_back(far_ball(glowing(0, 0, 0)));
    return look(scene(all), {{1, 0, -5}, {0, 0, 1}}).rgb.r;
  };
  EXPECT_EQ(seen(2), 1);
  EXPECT_EQ(seen(3), 0);
}

// As POV-Ray 3.7.0 counts: one sphere and two light sources, with +MB3.
TEST(Bounds, LightSourcesCountAsObjectsOfTheHierarchy) {
  const auto seen = [](int lights) {
    auto b = object(sphere({0, 0, 0}, 1.5), glowing(1, 0, 0));
    b->extras.edit().bounded_by = {object(box({-.5, -.5, -2}, {.5, .5, 2}))};
    std::vector<ObjectPtr> all{b};
    for (int i = 0; i < lights; ++i) all.push_back(light({0, 0, -10}, Rgb(1.0f)));
    return look(scene(all), {{1, 0, -5}, {0, 0, 1}}).rgb.r;
  };
  EXPECT_EQ(seen(1), 1);
  EXPECT_EQ(seen(2), 0);
}

TEST(LooksLike, StandsAtItsPlaceAndCastsNoShadow) {  // chapter 40 §10.5
  auto lamp = light({0, 0, -10}, Rgb(1.0f), [](LightSource& l) { l.looks_like = object(sphere({0, 0, -10}, 1), glowing(0, 1, 0)); });
  Scene s = scene({lamp, wall(texture(rgbft(1, 1, 1), finish(0, 1)))});
  expect_rgb(look(s, {{0, 0, -50}, {0, 0, 1}}), 0, 1, 0);
  expect_grey(look(s, camera()), 1);
}

TEST(GeometryAnswers, TraceInsideAndExtent) {  // chapter 10 §8.3
  GeometryAnswers answers;
  const ObjectPtr b = ball();
  const auto hit = answers.trace(b, {0, 0, -5}, {0, 0, 1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->point.z, -1, 1e-12);
  EXPECT_NEAR(hit->normal.z, -1, 1e-12);
  EXPECT_FALSE(answers.trace(b, {0, 3, -5}, {0, 0, 1}).has_value());
  EXPECT_TRUE(answers.inside(b, {0, .9, 0}));
  EXPECT_FALSE(answers.inside(b, {0, 1.1, 0}));
  EXPECT_NEAR(answers.extent(b).hi.x, 1, 1e-6);
  EXPECT_EQ(answers.extent(object(plane({0, 1, 0}, 0))).lo.x, -1e10);
}

}  // namespace
}  // namespace lute::testing
