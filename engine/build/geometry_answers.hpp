// Answers a scene's questions about its own objects (trace, inside, min_extent, max_extent) with the solids that the renderer
// would build. Objects are built on the first question and kept.
#pragma once

#include <map>
#include <memory>

#include "engine/build/built_scene.hpp"
#include "engine/scene/geometry_query.hpp"

namespace lute {

class GeometryAnswers final : public GeometryQuery {
 public:
  GeometryAnswers();
  ~GeometryAnswers() override;

  std::optional<SurfacePoint> trace(const ObjectPtr& object, const dvec3& origin, const dvec3& direction) override;
  bool inside(const ObjectPtr& object, const dvec3& point) override;
  Aabb extent(const ObjectPtr& object) override;
  std::optional<dvec2> image_size(const PigmentPtr& pigment) override;

 private:
  struct Built;
  const Built& built(const ObjectPtr& object);

  std::map<const Object*, std::unique_ptr<Built>> objects_;
};

// For object patterns and functions of them.
std::shared_ptr<const InsideTest> make_inside_test(const ObjectPtr& object);

}  // namespace lute
