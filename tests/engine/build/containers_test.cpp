// What contains the starts of camera rays, with and without the tree. Source: specification chapter 20 §8.1.
#include "engine/build/containers.hpp"

#include "tests/engine/shade/test_scene.hpp"

namespace lute::testing {
namespace {

// A row of balls of radius 1 at x = 0, 1, 2, ...; a large one around all; and the half space below y = -5. All clear: where nothing is,
// no tree of containers is built.
Scene row_of_balls(bool orthographic) {
  const TexturePtr clear = texture(rgbt(1, 1), finish(1, 0));
  std::vector<ObjectPtr> objects;
  for (int i = 0; i < 50; ++i) objects.push_back(object(sphere({static_cast<double>(i), 0, 0}, 1), clear));
  objects.push_back(object(sphere({25, 0, 0}, 100), clear));
  objects.push_back(object(plane({0, 1, 0}, -5), clear));
  Scene result = scene(objects);
  if (orthographic) result.camera.kind = CameraKind::kOrthographic;
  return result;
}

std::vector<const BuiltInterior*> interiors(const BuiltScene& built, const dvec3& point) {
  std::vector<const BuiltInterior*> found;
  built.interiors_at(point, found);
  return found;
}

TEST(Containers, AreTheSolidsAroundAPoint) {
  for (const bool orthographic : {false, true}) {
    const auto built = built_scene(row_of_balls(orthographic));
    EXPECT_EQ(interiors(*built, {10.5, 0, 0}).size(), 3u);    // balls 10 and 11, and the large one
    EXPECT_EQ(interiors(*built, {10.5, 0.9, 0}).size(), 1u);  // only the boxes of the balls hold it
    EXPECT_EQ(interiors(*built, {10.5, -6, 0}).size(), 2u);   // the large ball and the half space
    EXPECT_EQ(interiors(*built, {1000, 0, 0}).size(), 0u);
    EXPECT_EQ(interiors(*built, {-74.5, -6, 0}).size(), 2u);
  }
}

TEST(Containers, ComeInSceneOrder) {
  const auto plain = built_scene(row_of_balls(false)), indexed = built_scene(row_of_balls(true));
  const auto position = [](const BuiltScene& built, const BuiltInterior* wanted) {
    std::size_t i = 0;
    while (&built.interiors[i] != wanted) ++i;
    return i;
  };
  for (double x = -2; x < 52; x += 0.37) {
    const auto a = interiors(*plain, {x, 0, 0}), b = interiors(*indexed, {x, 0, 0});
    ASSERT_EQ(a.size(), b.size()) << x;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(position(*plain, a[i]), position(*indexed, b[i])) << x;
  }
}

}  // namespace
}  // namespace lute::testing
