// Questions that a scene's text asks about objects while it is being read: trace, inside, min_extent, max_extent.
// The application answers them with the real engine. Source: specification chapter 10 §8.3.
#pragma once

#include <optional>

#include "engine/math/aabb.hpp"
#include "engine/scene/object.hpp"

namespace lute {

class GeometryQuery {
 public:
  virtual ~GeometryQuery() = default;

  struct SurfacePoint {
    dvec3 point{0};
    dvec3 normal{0};  // as the shape reports it, flipped for an `inverse` object, not turned toward the ray
  };

  // Nearest hit at a distance of at least 1e-4 from `origin` along the unit vector `direction`.
  virtual std::optional<SurfacePoint> trace(const ObjectPtr& object, const dvec3& origin, const dvec3& direction) = 0;

  virtual bool inside(const ObjectPtr& object, const dvec3& point) = 0;

  // The box as used for bounding, in single precision; unbounded directions are +-1e10.
  virtual Aabb extent(const ObjectPtr& object) = 0;

  // Width and height in pixels of a pigment with an image_map; nothing for other pigments.
  virtual std::optional<dvec2> image_size(const PigmentPtr& pigment) = 0;
};

}  // namespace lute
