// From a ray to its colour (§3).
#include <algorithm>

#include "engine/shade/fog.hpp"
#include "engine/shade/rainbow.hpp"
#include "engine/shade/shader.hpp"

namespace lute {
namespace {

// Rays that pass straight on have no level: this bounds the stack. Beyond, a surface looks as it does beyond max_trace_level.
constexpr int kMaxDepth = 1000;
// Bounds the time that one camera ray may take, whatever the levels and the bailout of the scene allow.
constexpr std::uint64_t kMaxRays = std::uint64_t{1} << 22;

}  // namespace

bool TracedRay::hollow() const {
  return std::ranges::all_of(interiors.view(), [](const BuiltInterior* interior) { return interior->hollow; });
}

Color Shader::trace(const TracedRay& ray, float weight) {
  if (level_ >= settings_.max_trace_level || weight < settings_.adc_bailout) return {};
  if (depth_ >= kMaxDepth || ++rays_ > kMaxRays) return {};
  const int outer_level = level_;
  if (!ray.continues) ++level_;
  ++depth_;
  context_.counters.deepest_level = std::max(context_.counters.deepest_level, level_);

  Hit hit;
  // What touches the surface that a ray passes, or the camera, is seen behind it. A ray that turns keeps clear of everything nearby, as in
  // POV-Ray: the pictures of small things depend on it.
  const bool straight = ray.continues || ray.from == nullptr;
  const bool found = scene_.tree->nearest(ray.ray, {straight ? kNearestDepth : kMinimumDepth, ray.reach}, ray.kind, hit,
                                          context_.counters, {ray.from, kMinimumDepth});
  Color color = found ? shade(ray, hit, weight) : miss(ray);
  if (plan_.volume_effects) add_volume_effects(ray, found ? hit.t : kDepthOfMiss, color);

  --depth_;
  level_ = outer_level;
  return color;
}

Color Shader::miss(const TracedRay& ray) const {
  return sky_color(scene_, ray.ray.direction, settings_.output_alpha && !ray.kind.reflected);
}

void Shader::add_volume_effects(const TracedRay& ray, double depth, Color& color) {
  if (!ray.hollow()) return;
  if (plan_.rainbow) add_rainbows(scene_.rainbows, ray.ray, depth, context_.random, color);
  if (plan_.fog) add_fogs(scene_.fogs, settings_.noise_generator, ray.ray, depth, color);
}

}  // namespace lute
