#include "engine/accel/scene_tree.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/csg/leaf_solid.hpp"
#include "engine/shape/box.hpp"
#include "engine/shape/plane.hpp"
#include "engine/shape/sphere.hpp"

namespace lute {
namespace {

class NoSharing final : public BuildContext {
 public:
  std::shared_ptr<const void> find_shared(const void*) const override { return nullptr; }
  void store_shared(const void*, std::shared_ptr<const void>) override {}
};

std::unique_ptr<Solid> sphere(const dvec3& center, double radius, bool opaque = true) {
  NoSharing context;
  Leaf leaf;
  leaf.shape = build(Sphere{center, radius}, Transform(), context);
  leaf.opaque = opaque;
  return std::make_unique<LeafSolid>(std::move(leaf));
}

struct Spheres {
  std::vector<std::unique_ptr<Solid>> owned;
  std::vector<const Solid*> solids;
  void add(const dvec3& center, double radius, bool opaque = true) {
    owned.push_back(sphere(center, radius, opaque));
    solids.push_back(owned.back().get());
  }
};

// The oracle asks every solid in turn.
bool nearest_of_all(const Spheres& spheres, const Ray& ray, Interval range, Hit& hit) {
  bool found = false;
  for (const Solid* solid : spheres.solids) {
    Hit candidate;
    if (!solid->nearest(ray, range, RayKind(), candidate) || (found && !(candidate.t < hit.t))) continue;
    hit = candidate;
    found = true;
  }
  return found;
}

TEST(SceneTree, FindsWhatAskingEverySolidFinds) {
  for (const double scale : {1e-3, 1.0, 1e5}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    Spheres spheres;
    for (int i = 0; i < 300; ++i)
      spheres.add(scale * dvec3(unit(random), unit(random), unit(random)), scale * 0.05 * (1.1 + unit(random)));
    const SceneTree tree(spheres.solids);
    Counters counters;
    LastBlocker last;
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
      const dvec3 origin = 2 * scale * dvec3(unit(random), unit(random), unit(random));
      const dvec3 target = scale * dvec3(unit(random), unit(random), unit(random));
      const Ray ray{origin, glm::normalize(target - origin)};
      const Interval range{1e-4, 1e7};
      Hit expected, actual;
      const bool found = nearest_of_all(spheres, ray, range, expected);
      ASSERT_EQ(tree.nearest(ray, range, RayKind(), actual, counters), found);
      EXPECT_EQ(tree.obstruction(ray, range, last, counters), found ? Obstruction::kOpaque : Obstruction::kNone);
      if (!found) continue;
      ++hits;
      EXPECT_EQ(actual.t, expected.t);
      EXPECT_EQ(actual.leaf, expected.leaf);
    }
    EXPECT_GT(hits, 300);  // the comparison has met something
  }
}

// Few solids stand in a list, many in a tree; the last blocker is remembered between the rays.
TEST(SceneTree, ObstructionIsThatOfAskingEverySolid) {
  for (const int count : {4, 60}) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    Spheres spheres;
    for (int i = 0; i < count; ++i) {
      spheres.add({unit(random), unit(random), unit(random)}, count > 10 ? 0.1 : 0.4, i % 2 == 0);
      spheres.owned.back()->visibility.no_shadow = i % 4 > 1;
    }
    const SceneTree tree(spheres.solids);
    Counters counters;
    LastBlocker last;
    int seen[3] = {};
    for (int i = 0; i < 3000; ++i) {
      const Ray ray{{unit(random), unit(random), -3}, {0, 0, 1}};
      const Interval range{1e-3, 3 + unit(random)};
      Obstruction expected = Obstruction::kNone;
      for (const Solid* solid : spheres.solids) {
        if (solid->visibility.no_shadow || !solid->any(ray, range, RayKind())) continue;
        expected = std::max(expected, solid->opaque ? Obstruction::kOpaque : Obstruction::kFilter);
      }
      ++seen[static_cast<int>(expected)];
      ASSERT_EQ(tree.obstruction(ray, range, last, counters), expected) << count << ' ' << i;
    }
    for (const int times : seen) EXPECT_GT(times, 100);
  }
}

// Specification chapter 20 §2.3: among exactly coincident surfaces the first declared wins.
TEST(SceneTree, FirstDeclaredWinsExactTies) {
  Spheres spheres;
  for (int i = 0; i < 9; ++i) spheres.add({0, 0, 0}, 1);
  const SceneTree tree(spheres.solids);
  Counters counters;
  Hit hit;
  ASSERT_TRUE(tree.nearest({{0, 0, -5}, {0, 0, 1}}, {1e-4, 1e7}, RayKind(), hit, counters));
  std::vector<const Leaf*> leaves;
  spheres.solids[0]->leaves(leaves);
  EXPECT_EQ(hit.leaf, leaves[0]);
}

TEST(SceneTree, AxisParallelRaysWithNegativeZeroMeetTheirBoxes) {
  Spheres spheres;
  for (int i = -3; i <= 3; ++i) spheres.add({2.5 * i, 0, 0}, 1);
  const SceneTree tree(spheres.solids);
  Counters counters;
  Hit hit;
  EXPECT_TRUE(tree.nearest({{5, 0, -5}, {-0.0, 0.0, 1}}, {1e-4, 1e7}, RayKind(), hit, counters));
  EXPECT_FALSE(tree.nearest({{3.75, 0.9, -5}, {-0.0, -0.0, 1}}, {1e-4, 1e7}, RayKind(), hit, counters));
}

std::unique_ptr<Solid> box(const dvec3& lo, const dvec3& hi) {
  NoSharing context;
  Leaf leaf;
  leaf.shape = build(Box{lo, hi}, Transform(), context);
  return std::make_unique<LeafSolid>(std::move(leaf));
}

// Specification chapter 20 §1: a box of more than 2e10 cubic units counts as infinite, and infinite solids come first.
TEST(SceneTree, SolidsOfHugeVolumeWinTiesLikeUnboundedOnes) {
  for (const double side : {1e3, 1e5}) {
    const auto small = box({-1, -1, 0}, {1, 1, 1}), large = box({-side, -side, 0}, {side, side, side});
    const std::vector<const Solid*> solids{small.get(), large.get()};
    const SceneTree tree(solids);
    Counters counters;
    Hit hit;
    ASSERT_TRUE(tree.nearest({{0, 0, -5}, {0, 0, 1}}, {1e-4, 1e7}, RayKind(), hit, counters));
    std::vector<const Leaf*> leaves;
    (side > 1e4 ? large : small)->leaves(leaves);
    EXPECT_EQ(hit.leaf, leaves[0]) << side;
  }
}

TEST(SceneTree, UnboundedSolidsAreFoundBehindAndBeforeTheOthers) {
  NoSharing context;
  Leaf leaf;
  leaf.shape = build(Plane{}, Transform::translate({0, -1, 0}), context);
  const LeafSolid plane(std::move(leaf));
  const Leaf* ground = &plane.leaf();
  Spheres spheres;
  for (int i = 0; i < 20; ++i) spheres.add({2.5 * i, 0, 0}, 1);
  spheres.solids.push_back(&plane);
  const SceneTree tree(spheres.solids);
  Counters counters;
  Hit hit;
  ASSERT_TRUE(tree.nearest({{1.25, 5, 0}, {0, -1, 0}}, {1e-4, 1e7}, RayKind(), hit, counters));
  EXPECT_EQ(hit.leaf, ground);
  ASSERT_TRUE(tree.nearest({{2.5, 5, 0}, {0, -1, 0}}, {1e-4, 1e7}, RayKind(), hit, counters));
  EXPECT_EQ(hit.t, 4);
  ASSERT_TRUE(tree.nearest({{2.5, -5, 0}, {0, 1, 0}}, {1e-4, 1e7}, RayKind(), hit, counters));
  EXPECT_EQ(hit.leaf, ground);
}

TEST(SceneTree, EmptySceneHasNoHits) {
  const SceneTree tree(std::span<const Solid* const>{});
  Counters counters;
  Hit hit;
  EXPECT_FALSE(tree.nearest(Ray(), {0, 1}, RayKind(), hit, counters));
}

}  // namespace
}  // namespace lute
