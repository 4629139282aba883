// Specification chapter 20 §6 and §12 (check cases named at each test).
#include "engine/csg/csg_solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "engine/csg/bounding.hpp"
#include "engine/shape/box.hpp"
#include "engine/shape/cylinder.hpp"
#include "engine/shape/height_field.hpp"
#include "engine/shape/plane.hpp"
#include "engine/shape/quadric.hpp"
#include "engine/shape/sphere.hpp"

namespace lute {
namespace {

class NoCache final : public BuildContext {
 public:
  std::shared_ptr<const void> find_shared(const void*) const override { return nullptr; }
  void store_shared(const void*, std::shared_ptr<const void>) override {}
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kAhead{1e-4, kInfinity};

template <class Description>
std::unique_ptr<Solid> leaf(const Description& description, int color, bool inverted = false, SharedSolids clips = {},
                            SharedSolids bounds = {}) {
  NoCache cache;
  Leaf result;
  result.shape = build(description, Transform{}, cache);
  result.inverted = inverted;
  result.light_group = color;  // any number that tells the leaves apart
  return std::make_unique<LeafSolid>(std::move(result), std::move(clips), std::move(bounds));
}

template <class... Solids>
std::unique_ptr<CsgSolid> combine(CsgKind kind, Solids... solids) {
  CsgSolid::Children children;
  (children.push_back(std::move(solids)), ...);
  return std::make_unique<CsgSolid>(kind, std::move(children));
}

// The number of the leaf seen from z = -10 along z, -1 for none. Asked twice: nearest() and the full list must agree.
int seen(const Solid& solid, double x, double y, RayKind kind = {}) {
  const Ray ray{{x, y, -10}, {0, 0, 1}};
  Hit hit;
  const bool found = solid.nearest(ray, kAhead, kind, hit);
  Hit from_list;
  EXPECT_EQ(found, solid.Solid::nearest(ray, kAhead, kind, from_list));
  EXPECT_EQ(found, solid.any(ray, kAhead, kind));
  if (found) {
    EXPECT_EQ(hit.t, from_list.t);
    EXPECT_EQ(hit.leaf, from_list.leaf);
  }
  return found ? hit.leaf->light_group : -1;
}

const Box kCube{dvec3(-1), dvec3(1)};
constexpr int kRed = 1, kGreen = 2;

// Check case 10.
TEST(Csg, LastOfCoincidentUnionFacesWins) {
  EXPECT_EQ(seen(*combine(CsgKind::kUnion, leaf(kCube, kRed), leaf(kCube, kGreen)), .2, .3), kGreen);
}
TEST(Csg, MergeOfEqualBoxesVanishes) {
  EXPECT_EQ(seen(*combine(CsgKind::kMerge, leaf(kCube, kRed), leaf(kCube, kGreen)), .2, .3), -1);
}
TEST(Csg, LastOfCoincidentIntersectionFacesWins) {
  EXPECT_EQ(seen(*combine(CsgKind::kIntersection, leaf(kCube, kRed), leaf(kCube, kGreen)), .2, .3), kGreen);
}
TEST(Csg, CutBoxKeepsTheCuttersFace) {
  const auto csg = combine(CsgKind::kDifference, leaf(kCube, kRed), leaf(Box{dvec3(-1), {1, 0, 1}}, kGreen, true));
  EXPECT_EQ(seen(*csg, .2, .5), kRed);
  EXPECT_EQ(seen(*csg, .2, -.5), kGreen);
}
TEST(Csg, CutCylinderSharingItsEndKeepsASkin) {
  const auto csg = combine(CsgKind::kDifference, leaf(Cylinder{{0, 0, -1}, {0, 0, 1}, 1}, kRed),
                           leaf(Cylinder{{0, 0, -1}, {0, 0, 0}, .5}, kGreen, true));
  EXPECT_EQ(seen(*csg, .2, .1), kRed);
}
TEST(Csg, PlaneThatSharesABoxFaceWins) {
  const auto csg = combine(CsgKind::kDifference, leaf(kCube, kRed), leaf(Plane{{0, 0, 1}, -1}, kGreen, true));
  EXPECT_EQ(seen(*csg, .2, .5), kGreen);
}

TEST(Csg, DifferenceShowsTheInsideOfTheCutter) {
  const auto csg = combine(CsgKind::kDifference, leaf(Sphere{dvec3(0), 1.5}, kRed), leaf(Sphere{{0, 0, -1.5}, 1}, kGreen, true));
  EXPECT_EQ(seen(*csg, 0, 0), kGreen);
  EXPECT_EQ(seen(*csg, 0, 1.2), kRed);
  EXPECT_FALSE(csg->inside({0, 0, -1}));
  EXPECT_TRUE(csg->inside({0, 0, .5}));
}

// A sphere's surface is inside of neither itself nor its inverse (chapter 20 §5.1), so that of two equal spheres one wall must stay
// where both cut or both limit, and nothing where one cuts the other. In the reference rounding decides, pixel by pixel.
TEST(Csg, OfTwoEqualSpheresOneWallStaysAndTheirDifferenceVanishes) {
  const Sphere ball{{0.1, 0.2, 0.3}, 1};
  auto cut = combine(CsgKind::kDifference, leaf(Box{dvec3(-3, -3, 0), dvec3(3)}, kRed),
                     combine(CsgKind::kIntersection, leaf(ball, kGreen, true), leaf(ball, kGreen, true)));
  EXPECT_EQ(seen(*cut, .2, .3), kGreen);
  EXPECT_EQ(seen(*combine(CsgKind::kIntersection, leaf(ball, kRed), leaf(ball, kRed)), .2, .3), kRed);
  EXPECT_EQ(seen(*combine(CsgKind::kDifference, leaf(ball, kRed), leaf(ball, kGreen, true)), .2, .3), -1);
}

TEST(Csg, IntersectionBoxIsThatOfItsUprightChildren) {
  const auto csg = combine(CsgKind::kIntersection, leaf(Sphere{dvec3(0), 1}, kRed), leaf(Plane{{0, 1, 0}, .5}, kGreen),
                           leaf(Sphere{dvec3(0), .1}, kGreen, true));
  EXPECT_NEAR(csg->box().hi.y, .5, 1e-6);
  EXPECT_NEAR(csg->box().lo.y, -1, 1e-6);
}

// Check case 17: what a child's no_image hides.
// x² - y² + z² = 1 between y = -2 and 1 reaches √5 at the lower end; bevelled boards are bounded by each other.
TEST(Csg, PlanesBoundQuadricsAndEachOther) {
  const auto vase = combine(CsgKind::kIntersection, leaf(Quadric{{1, -1, 1}, {0, 0, 0}, {0, 0, 0}, -1}, kRed),
                            leaf(Plane{{0, 1, 0}, 1}, kGreen), leaf(Plane{{0, -1, 0}, 2}, kGreen));
  EXPECT_NEAR(vase->box().hi.x, std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(vase->box().lo.z, -std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(vase->box().lo.y, -2, 1e-6);
  EXPECT_NEAR(vase->box().hi.y, 1, 1e-6);

  const auto board = combine(CsgKind::kIntersection, leaf(Plane{{0, 1, 0}, -.15}, kRed), leaf(Plane{{0, -1, 0}, 3}, kRed),
                             leaf(Plane{{0, 0, -1}, 35}, kRed), leaf(Plane{{-1, 0, 1}, 0}, kRed), leaf(Plane{{1, 0, 1}, 0}, kRed));
  EXPECT_NEAR(board->box().lo.x, -35, 1e-6);
  EXPECT_NEAR(board->box().hi.x, 35, 1e-6);
  EXPECT_TRUE(board->box().is_finite());
}

TEST(Csg, NoImageOfAChild) {
  for (const CsgKind kind : {CsgKind::kUnion, CsgKind::kMerge, CsgKind::kIntersection}) {
    auto marked = leaf(Sphere{dvec3(0), .7}, kRed);
    marked->visibility.no_image = true;
    const auto csg = combine(kind, std::move(marked), leaf(Sphere{{0, 0, 0}, .7000001}, kGreen));
    const int primary = seen(*csg, 0, 0);
    EXPECT_EQ(primary, kind == CsgKind::kIntersection ? kRed : kGreen);
    RayKind refracted;
    refracted.primary = false;
    refracted.refracted = true;
    EXPECT_EQ(seen(*csg, 0, 0, refracted), kind == CsgKind::kIntersection ? kRed : kGreen);
    RayKind shadow;
    shadow.shadow = true;
    EXPECT_NE(seen(*csg, 0, 0, shadow), -1);
  }
}

TEST(Csg, ClippedSolidIsOpen) {
  SharedSolids clips;
  clips.push_back(leaf(Plane{{0, 0, -1}, 0}, 0));  // keeps z > 0
  const auto clipped = leaf(Sphere{dvec3(0), 1}, kRed, false, clips);
  Hit hit;
  ASSERT_TRUE(clipped->nearest({{0, 0, -10}, {0, 0, 1}}, kAhead, {}, hit));
  EXPECT_DOUBLE_EQ(hit.point.z, 1);  // the far side is seen from within
  EXPECT_FALSE(clipped->inside({0, 0, -.5}));
  EXPECT_TRUE(clipped->plain_inside({0, 0, -.5}));
  EXPECT_NEAR(clipped->box().lo.z, 0, 1e-6);
}

// Check case 11: the box of a bound cuts, as soon as boxes are used.
TEST(Csg, SmallerBoxOfABoundCuts) {
  SharedSolids bounds;
  bounds.push_back(leaf(Box{{-.5, -.5, -2}, {.5, .5, 2}}, 0));
  const auto bounded = leaf(Sphere{dvec3(0), 1.5}, kRed, false, {}, bounds);
  EXPECT_EQ(seen(*bounded, .4, .4), kRed);
  EXPECT_EQ(seen(*bounded, .8, .4), -1);
}

// The same for the box of a clip whose inside reaches out of it: below a height field everything is inside. Measured with POV-Ray: of a
// union nothing is seen below the lowest ground; of a box alone it is, which is not tested with its own box.
TEST(Csg, ObjectClippedByAHeightFieldEndsAtTheLowestGround) {
  auto grid = std::make_shared<HeightGrid>();
  grid->width = grid->depth = 2;
  grid->heights = {20000, 40000, 20000, 40000};  // 0.31 to 0.61
  HeightField ground;
  ground.grid = grid;
  SharedSolids clips;
  clips.push_back(leaf(ground, 0));
  CsgSolid::Children ball;
  ball.push_back(leaf(Sphere{{.9, .4, .5}, .5}, kRed));
  const CsgSolid clipped(CsgKind::kUnion, std::move(ball), clips);
  EXPECT_EQ(seen(clipped, .9, .5), kRed);
  EXPECT_EQ(seen(clipped, .9, .2), -1);

  NoCache cache;
  Leaf cube;
  cube.shape = build(Box{{.1, -2, .1}, {.95, 2, .9}}, Transform{}, cache);
  cube.light_group = kGreen;
  const LeafSolid alone(std::move(cube), clips, {}, BoundTest::kTested, false);
  EXPECT_EQ(seen(alone, .9, .2), kGreen);
  EXPECT_EQ(seen(alone, .9, .7), -1);
}

// Check case 13: the textures of a cut surface.
TEST(Csg, CutawaySharesComeFromWhatThePointIsIn) {
  const auto* texture = reinterpret_cast<const CompiledTexture*>(&kCube);  // only compared with null
  const auto textured = [&](const Sphere& sphere, int color) {
    auto solid = leaf(sphere, color);
    const_cast<Leaf&>(static_cast<LeafSolid&>(*solid).leaf()).texture.texture = texture;
    return solid;
  };
  const auto csg = combine(CsgKind::kDifference,
                           combine(CsgKind::kUnion, textured({{-.5, 0, 0}, 1}, kRed), textured({{.5, 0, 0}, 1}, kGreen)),
                           leaf(Box{dvec3(-2), {2, 2, 0}}, 0, true));
  Hit hit;
  ASSERT_TRUE(csg->nearest({{0, 0, -10}, {0, 0, 1}}, kAhead, {}, hit));
  EXPECT_EQ(hit.cutaway, csg.get());
  CsgSolid::CutawayShares shares;
  hit.cutaway->cutaway_shares({0, 0, 0}, *hit.leaf, shares);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].second, .5);
}

// A knife within what is cut: its own surface shows the solid that it cuts, all over. (POV-Ray's inside test of the surface is rounding, so that it
// speckles with black, for spheres, boxes and cylinders alike.)
TEST(Csg, CutawaySharesOfAnInnerKnife) {
  const auto* texture = reinterpret_cast<const CompiledTexture*>(&kCube);  // only compared with null
  const auto knives = [](int which) {
    return which == 0 ? leaf(Sphere{{0, 0, -1}, .8}, 0, true) : leaf(Box{{-.6, -.5, -2}, {.7, .8, -.1}}, 0, true);
  };
  for (const int which : {0, 1}) {
    auto ball = leaf(Sphere{dvec3(0), 1}, kRed);
    const_cast<Leaf&>(static_cast<LeafSolid&>(*ball).leaf()).texture.texture = texture;
    const auto csg = combine(CsgKind::kDifference, combine(CsgKind::kDifference, std::move(ball), knives(which)),
                             leaf(Sphere{{0, 3, 0}, 1}, 0, true));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-.45, .45);
    for (int i = 0; i < 200; ++i) {
      Hit hit;
      ASSERT_TRUE(csg->nearest({{unit(random), unit(random), -5}, {0, 0, 1}}, kAhead, {}, hit));
      ASSERT_EQ(hit.leaf->texture.texture, nullptr);
      CsgSolid::CutawayShares shares;
      hit.cutaway->cutaway_shares(hit.point, *hit.leaf, shares);
      ASSERT_EQ(shares.size(), 1u) << "knife " << which << " ray " << i;
      EXPECT_EQ(shares[0].second, 1);
    }
  }
}

// Many children are found through a tree; few are gone through. Both must agree with asking every child.
TEST(Csg, ManyChildrenAgreeWithAskingEach) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const CsgKind kind : {CsgKind::kUnion, CsgKind::kMerge}) {
    CsgSolid::Children children, alone;
    for (int i = 0; i < 60; ++i) {
      const Sphere ball{{3 * unit(random), 3 * unit(random), 3 * unit(random)}, .5 + .3 * unit(random)};
      children.push_back(leaf(ball, i));
      alone.push_back(leaf(ball, i));
    }
    const CsgSolid csg(kind, std::move(children));
    for (int i = 0; i < 500; ++i) {
      const double x = 3 * unit(random);
      const double y = 3 * unit(random);
      const Ray ray{{x, y, -10}, {0, 0, 1}};
      double nearest = kInfinity;
      for (const auto& child : alone) {
        Hit hit;
        if (child->nearest(ray, kAhead, {}, hit)) nearest = std::min(nearest, hit.t);
      }
      Hit hit;
      ASSERT_EQ(csg.nearest(ray, kAhead, {}, hit), nearest < kInfinity);
      if (nearest < kInfinity) {
        EXPECT_EQ(hit.t, nearest);
      }
      seen(csg, x, y);
      const dvec3 point(x, y, 3 * unit(random));
      EXPECT_EQ(csg.inside(point), std::ranges::any_of(alone, [&](const auto& child) { return child->inside(point); }));
    }
  }
}

// Counts how often a solid is asked for hits, or whether a point is inside.
class Counted final : public Solid {
 public:
  explicit Counted(std::unique_ptr<Solid> solid) : solid_(std::move(solid)) {}
  static inline long asked = 0;

  void hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const override {
    ++asked;
    solid_->hits(ray, range, kind, out);
  }
  bool inside(const dvec3& point) const override {
    ++asked;
    return solid_->inside(point);
  }
  bool plain_inside(const dvec3& point) const override { return solid_->plain_inside(point); }
  void leaves(std::vector<const Leaf*>& out) const override { solid_->leaves(out); }
  Aabb hits_within(const Aabb& region) const override { return solid_->hits_within(region); }
  Aabb inside_within(const Aabb& region) const override { return solid_->inside_within(region); }
  Aabb outside_bounds() const override { return solid_->outside_bounds(); }

 private:
  Aabb own_box() const override { return solid_->box(); }
  Aabb own_inside_box() const override { return solid_->inside_box(); }
  std::unique_ptr<Solid> solid_;
};

// Combinations of any number of children. The points on a sphere are declared along a spiral, from pole to pole.
struct WideCase {
  const char* name;
  CsgKind kind;
  std::unique_ptr<Solid> (*child)(int i, int count);
};
void PrintTo(const WideCase& c, std::ostream* out) { *out << c.name; }

dvec3 on_spiral(int i, int count) {
  const double y = 1 - 2 * (i + 0.5) / count;
  const double r = std::sqrt(1 - y * y);
  return {r * std::cos(2.4 * i), y, r * std::sin(2.4 * i)};
}

const WideCase kWideCases[] = {
    {"TangentPlanes", CsgKind::kIntersection, [](int i, int count) { return leaf(Plane{on_spiral(i, count), 1}, i); }},
    {"OverlappingSpheres", CsgKind::kIntersection, [](int i, int count) { return leaf(Sphere{0.5 * on_spiral(i, count), 1.3}, i); }},
    {"ShellsFromTheInmost", CsgKind::kIntersection, [](int i, int count) { return leaf(Sphere{dvec3(0), 1 + 1.0 * i / count}, i); }},
    {"ShellsFromTheOutmost", CsgKind::kIntersection, [](int i, int count) { return leaf(Sphere{dvec3(0), 2 - 1.0 * i / count}, i); }},
    {"ShiftedSpheres", CsgKind::kIntersection, [](int i, int count) { return leaf(Sphere{{0, 0, 1.0 * i / count}, 1.3}, i); }},
    {"OverlappingMerge", CsgKind::kMerge, [](int i, int count) { return leaf(Sphere{0.5 * on_spiral(i, count), 1.3}, i); }},
    {"OverlappingCutters", CsgKind::kDifference,
     [](int i, int count) {
       return i == 0 ? leaf(Box{dvec3(-1), dvec3(1)}, i) : leaf(Sphere{on_spiral(i, count), .3}, i, true);
     }},
    {"CuttersInAGrid", CsgKind::kDifference,
     [](int i, int count) {
       if (i == 0) return leaf(Box{dvec3(-1, -1, -0.2), dvec3(1, 1, 0.2)}, i);
       const int side = static_cast<int>(std::sqrt(count - 1));
       const double cell = 2.0 / side;
       return leaf(Sphere{{-1 + cell * ((i - 1) % side + 0.5), -1 + cell * ((i - 1) / side + 0.5), -0.2}, 0.45 * cell}, i, true);
     }},
};

class WideCsg : public testing::TestWithParam<WideCase> {
 protected:
  // What the same rays ask of the children in all: for the nearest hit, for all hits, and for any.
  static long work(int count) {
    CsgSolid::Children children;
    for (int i = 0; i < count; ++i) children.push_back(std::make_unique<Counted>(GetParam().child(i, count)));
    const CsgSolid solid(GetParam().kind, std::move(children));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    Counted::asked = 0;
    int met = 0;
    for (int i = 0; i < 60; ++i) {
      const Ray ray{{unit(random), unit(random), -10}, glm::normalize(dvec3(.05 * unit(random), .05 * unit(random), 1))};
      Hit hit;
      Hits all;
      if (solid.nearest(ray, kAhead, RayKind{}, hit)) ++met;
      solid.hits(ray, kAhead, RayKind{}, all);
      EXPECT_EQ(solid.any(ray, kAhead, RayKind{}), !all.empty());
    }
    EXPECT_GT(met, 15);
    return Counted::asked;
  }
};

// N log N is 14 times as much, N² a hundred times.
TEST_P(WideCsg, TenTimesTheChildrenCostSixteenTimesTheWorkAtMost) { EXPECT_LE(work(4001), 16 * work(401)); }

// Each child counts in the mean a few times a ray and query.
TEST_P(WideCsg, AsksEveryChildAFewTimes) { EXPECT_LT(work(1001), 6L * 1001 * 60 * 3); }

INSTANTIATE_TEST_SUITE_P(Csg, WideCsg, testing::ValuesIn(kWideCases), [](const auto& test) { return test.param.name; });

TEST(Csg, NestedToDepthAHundred) {
  // Each level cuts a sphere out of the front of the level below and adds one: at (k, 0) the inside of the cut is seen.
  std::unique_ptr<Solid> nested = leaf(Sphere{{0, 0, 0}, 0.4}, 0);
  for (int level = 1; level <= 100; ++level) {
    auto cut = combine(CsgKind::kDifference, std::move(nested), leaf(Sphere{{level - 1, 0, -0.4}, 0.3}, 1000, true));
    nested = combine(CsgKind::kMerge, std::move(cut), leaf(Sphere{{level, 0, 0}, 0.4}, level));
  }
  for (int level = 0; level < 100; ++level) {
    EXPECT_EQ(seen(*nested, level, -0.35), level);
    EXPECT_EQ(seen(*nested, level, 0), 1000) << level;
    EXPECT_EQ(seen(*nested, level + 0.5, 0), -1);
  }
}

TEST(Csg, NestedCombinationsKeepTheirHitsApart) {
  auto inner = combine(CsgKind::kMerge, leaf(Sphere{{0, 0, -1}, .5}, kRed), leaf(Sphere{{0, 0, -.8}, .5}, kGreen));
  auto middle = combine(CsgKind::kMerge, std::move(inner), leaf(Sphere{{0, 0, .5}, .2}, 3));
  const auto outer = combine(CsgKind::kIntersection, std::move(middle), leaf(Box{dvec3(-1.2), dvec3(2)}, 4));
  Hits hits;
  outer->hits({{0, 0, -10}, {0, 0, 1}}, kAhead, {}, hits);
  EXPECT_EQ(hits.size(), 4u);
  EXPECT_EQ(seen(*outer, 0, 0), 4);
}

// A ray passes a sphere from 4 to 6, and a half-space up to 5.5.
TEST(Clips, TellTheRangeInWhichARayCanBeInsideAll) {
  SharedSolids clips;
  clips.push_back(leaf(Sphere{{0, 0, 5}, 1}, 0));
  clips.push_back(leaf(Plane{{0, 0, 1}, 5.5}, 0));
  const Interval all{0, std::numeric_limits<double>::infinity()};
  const Interval both = range_inside_all(clips, {dvec3(0), {0, 0, 1}}, all);
  EXPECT_NEAR(both.lo, 4, 1e-5);
  EXPECT_NEAR(both.hi, 5.5, 1e-5);
  EXPECT_LT(both.lo, 4);
  EXPECT_GT(both.hi, 5.5);
  EXPECT_TRUE(range_inside_all(clips, {dvec3(0, 2, 0), {0, 0, 1}}, all).empty());
  EXPECT_TRUE(range_inside_all(clips, {dvec3(0), {0, 0, 1}}, {5.6, 7}).empty());
}

}  // namespace
}  // namespace lute
