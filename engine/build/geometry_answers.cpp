#include "engine/build/geometry_answers.hpp"

#include <algorithm>
#include <cmath>

#include "engine/build/language_extent.hpp"
#include "engine/build/scene_builder.hpp"

namespace lute {

struct GeometryAnswers::Built {
  ObjectPtr object;  // its address is the key: it must not be reused
  BuiltScene scene;
};

GeometryAnswers::GeometryAnswers() = default;
GeometryAnswers::~GeometryAnswers() = default;

const GeometryAnswers::Built& GeometryAnswers::built(const ObjectPtr& object) {
  auto& slot = objects_[object.get()];
  if (slot == nullptr) {
    slot = std::make_unique<Built>();
    slot->object = object;
    slot->scene.textures = std::make_unique<TextureCompiler>(TextureSettings{});
    SceneBuilder builder(slot->scene, BuildOptions{});
    builder.add_geometry(object);
    builder.finish();
  }
  return *slot;
}

std::optional<GeometryAnswers::SurfacePoint> GeometryAnswers::trace(const ObjectPtr& object, const dvec3& origin,
                                                                    const dvec3& direction) {
  constexpr double kMinimumDepth = 1e-4;
  const Ray ray{origin, direction};
  Interval range;
  range.lo = kMinimumDepth;
  std::optional<SurfacePoint> result;
  Hit hit;
  Counters counters;
  RayKind kind;
  kind.primary = false;  // flags of visibility do not matter here
  if (!built(object).scene.tree->nearest(ray, range, kind, hit, counters)) return result;
  dvec3 normal = hit.leaf->shape->normal(hit.shape_hit, hit.point);
  if (hit.leaf->inverted) normal = -normal;
  return SurfacePoint{hit.point, normal};
}

bool GeometryAnswers::inside(const ObjectPtr& object, const dvec3& point) {
  const auto& solids = built(object).scene.solids;
  return std::ranges::any_of(solids, [&](const auto& s) { return s->may_contain(point) && s->inside(point); });
}

namespace {

Aabb tight_box(const Object& object) {
  BuiltScene scene;
  scene.textures = std::make_unique<TextureCompiler>(TextureSettings{});
  SceneBuilder builder(scene, BuildOptions{});
  builder.add_geometry(std::make_shared<const Object>(object));
  Aabb box;
  for (const auto& solid : scene.solids) box.join(solid->box());
  return box;
}

}  // namespace

Aabb GeometryAnswers::extent(const ObjectPtr& object) { return language_extent(*object, tight_box); }

std::optional<dvec2> GeometryAnswers::image_size(const PigmentPtr& pigment) {
  const auto* any = std::get_if<AnyPattern>(&pigment->body.pattern);
  const auto* image = any != nullptr ? std::get_if<ImageMap>(any) : nullptr;
  if (image == nullptr) return std::nullopt;
  return dvec2(image->mapping.image->width(), image->mapping.image->height());
}

namespace {

// Asked by many threads at once: built when it is made, and only read from then on.
class ObjectInside final : public InsideTest {
 public:
  explicit ObjectInside(const ObjectPtr& object) : object_(object) {
    scene_.textures = std::make_unique<TextureCompiler>(TextureSettings{});
    SceneBuilder builder(scene_, BuildOptions{});
    builder.add_geometry(object);
  }
  bool inside(const dvec3& point) const override {
    return std::ranges::any_of(scene_.solids, [&](const auto& s) { return s->may_contain(point) && s->inside(point); });
  }

 private:
  ObjectPtr object_;
  BuiltScene scene_;
};

}  // namespace

std::shared_ptr<const InsideTest> make_inside_test(const ObjectPtr& object) { return std::make_shared<ObjectInside>(object); }

}  // namespace lute
