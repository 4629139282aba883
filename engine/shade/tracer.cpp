#include "engine/shade/tracer.hpp"

#include <algorithm>

#include "engine/shade/shader.hpp"

namespace lute {

TraceContext::TraceContext() : scratch(std::make_unique<TraceScratch>()) {}
TraceContext::~TraceContext() = default;
TraceContext::TraceContext(TraceContext&&) noexcept = default;
TraceContext& TraceContext::operator=(TraceContext&&) noexcept = default;

Color Tracer::trace(const Ray& camera_ray, TraceContext& context, double reach) const {
  TracedRay ray;
  ray.ray = camera_ray;
  ray.reach = std::min(reach, kDepthOfMiss);
  ray.interiors = context.camera_interiors;
  ++context.counters.camera_rays;
  return Shader(scene_, plan_, context).trace(ray, 1);
}

InteriorList Tracer::interiors_at(const dvec3& point) const {
  if (!plan_.interiors) return {};
  std::vector<const BuiltInterior*> found;
  scene_.interiors_at(point, found);
  InteriorList list;
  for (const BuiltInterior* interior : found) list.append(interior);
  return list;
}

}  // namespace lute
