#include "engine/build/scene_scale.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <vector>

#include "engine/camera/projection.hpp"

namespace lute {
namespace {

// Where all that is bounded is nearer to the camera than the first, or each solid is larger than the second and as far
// away, the scene gets another unit.
constexpr double kTooSmall = 0.2, kTooLarge = 1e4;
constexpr double kWantedSize = 10;

double distance_to(const Aabb& box, const dvec3& point) {
  return glm::length(point - glm::clamp(point, box.lo, box.hi));
}

double farthest_corner(const Aabb& box, const dvec3& point) {
  return glm::length(glm::max(glm::abs(box.lo - point), glm::abs(box.hi - point)));
}

bool bounded(const Aabb& box) { return !box.empty() && glm::length(box.hi - box.lo) < 1e300; }

// The depths at which a grid of camera rays meets the solids.
std::vector<double> depths_seen(std::span<const std::unique_ptr<Solid>> solids, const Camera& camera) {
  constexpr int kGrid = 7;
  if (camera.kind == CameraKind::kMesh) return {};
  const Projection projection(camera, kGrid, kGrid);
  std::vector<double> depths;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    ProjectedRay projected;
    if (!projection.project({i % kGrid, i / kGrid}, projected)) continue;
    const Ray ray{projected.origin, glm::normalize(projected.direction)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& solid : solids) {
      Hit hit;
      if (solid->nearest(ray, {std::numeric_limits<double>::min(), nearest}, {}, hit)) nearest = hit.t;
    }
    if (std::isfinite(nearest)) depths.push_back(nearest);
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

}  // namespace

void SceneSize::add(const Aabb& box, const Camera& camera) {
  if (!bounded(box)) return;
  reach = std::max(reach, farthest_corner(box, camera.location));
  smallest = std::min({smallest, glm::length(box.hi - box.lo), distance_to(box, camera.location)});
}

SceneSize size_of(std::span<const std::unique_ptr<Solid>> solids, const Camera& camera) {
  SceneSize size;
  for (const auto& solid : solids) size.add(solid->box(), camera);
  if (size.reach > 0) return size;
  const std::vector<double> depths = depths_seen(solids, camera);
  if (depths.empty()) return {};
  return {depths[depths.size() / 2], depths.front()};
}

double rendering_scale(const SceneSize& size) {
  const bool too_small = size.reach > 0 && size.reach < kTooSmall;
  const bool too_large = size.reach > 0 && size.smallest > kTooLarge;
  if (!too_small && !too_large) return 1;
  const double measure = too_small ? size.reach : size.smallest;
  return std::exp2(std::clamp(std::round(std::log2(kWantedSize / measure)), -300.0, 300.0));
}

bool stays_ordinary(const SceneSize& size) { return size.reach >= kTooSmall && size.smallest <= kTooLarge; }

Camera scaled(Camera camera, double scale) {
  camera.location *= scale;
  camera.look_at *= scale;
  camera.focal_distance *= scale;
  camera.aperture *= scale;
  // The other vectors are directions, of which only the ratio counts.
  const bool flat = camera.kind == CameraKind::kOrthographic;
  if (flat || camera.kind == CameraKind::kCylinder4) camera.right *= scale;
  if (flat || camera.kind == CameraKind::kCylinder3) camera.up *= scale;
  return camera;
}

Fog scaled(Fog fog, double scale) {
  fog.distance *= scale;
  fog.offset *= scale;
  fog.altitude *= scale;
  if (fog.turbulence) fog.turbulence->amount /= scale;  // a frequency: the pattern grows with the scene
  return fog;
}

}  // namespace lute
