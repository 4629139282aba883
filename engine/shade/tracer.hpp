// The colour of a ray: Whitted's recursion, trace and shade. Source: specification chapter 40.
//
// A Tracer is immutable and shared by all threads; each thread has a TraceContext. To render a sample:
//   context.start_sample(pixel_number, sample_number);
//   Color c = tracer.trace(ray, context);        // c.transmit: 1 - alpha
// The interiors that the camera is in are taken from context.camera_interiors, which the caller fills with
// tracer.interiors_at(location), once, or for each ray where the camera's rays start at different places.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "engine/accel/counters.hpp"
#include "engine/build/built_scene.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/shade/interior_list.hpp"
#include "engine/shade/random.hpp"

namespace lute {

struct TraceScratch;  // engine/shade/scratch.hpp

class TraceContext {
 public:
  TraceContext();
  ~TraceContext();
  TraceContext(TraceContext&&) noexcept;
  TraceContext& operator=(TraceContext&&) noexcept;

  // Random numbers of what follows are those of this pixel and sample.
  void start_sample(std::uint64_t pixel, std::uint64_t sample) { random.start(pixel, sample); }

  Counters counters;
  SampleRandom random;
  InteriorList camera_interiors;
  std::unique_ptr<TraceScratch> scratch;
};

class Tracer {
 public:
  Tracer(const BuiltScene& scene, const RenderPlan& plan) : scene_(scene), plan_(plan) {}

  // `camera_ray` has a unit direction. What it hits at `reach` or farther does not count.
  Color trace(const Ray& camera_ray, TraceContext& context, double reach = std::numeric_limits<double>::infinity()) const;

  InteriorList interiors_at(const dvec3& point) const;
  const BuiltScene& scene() const { return scene_; }
  const RenderPlan& plan() const { return plan_; }

 private:
  const BuiltScene& scene_;
  const RenderPlan& plan_;
};

}  // namespace lute
