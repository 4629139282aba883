// The unit in which a scene is rendered.
//
// The language has depths below which hits do not count, shadows keep clear of their ends, and boxes count as infinite:
// 1e-4, 1e-3, 1e7, 2e10, in the scene's own units. They suit scenes about as large as their author. A scene that is as a
// whole far smaller or larger is rendered as if its author had used another unit: every length of the built scene is
// multiplied with one power of two, which rounds nothing.
#pragma once

#include <limits>
#include <memory>
#include <span>

#include "engine/csg/solid.hpp"
#include "engine/scene/atmosphere.hpp"
#include "engine/scene/camera.hpp"

namespace lute {

// How far from the camera the scene reaches, and the size or distance of the smallest or nearest thing in it.
struct SceneSize {
  double reach = 0;  // 0: nothing to measure
  double smallest = std::numeric_limits<double>::infinity();

  // Unbounded boxes count for nothing.
  void add(const Aabb& box, const Camera& camera);
};

// From the boxes of bounded solids; of a scene without any, from where a few camera rays meet it.
SceneSize size_of(std::span<const std::unique_ptr<Solid>> solids, const Camera& camera);

// 1 for a scene of ordinary size.
double rendering_scale(const SceneSize& size);
// That it is 1, and remains so whatever else is added.
bool stays_ordinary(const SceneSize& size);

// The same view of a scene whose lengths are multiplied with `scale`.
Camera scaled(Camera camera, double scale);
Fog scaled(Fog fog, double scale);

}  // namespace lute
