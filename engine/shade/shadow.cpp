// What stands between a point and a light (§11).
//
// The reference keeps the last opaque blocker of each light and tries it first, without the margins of §11 step 1. That makes an
// image depend on the order of its pixels; here the margins are kept, so that the order only saves time.
#include <cmath>

#include "engine/shade/fog.hpp"
#include "engine/shade/shader.hpp"
#include "engine/texture/blend.hpp"

namespace lute {
namespace {

// A shadow ray that crosses more surfaces than this is given up as dark.
constexpr int kMaxCrossings = 1 << 16;

bool hollow(const InteriorList& interiors) {
  for (const BuiltInterior* interior : interiors.view())
    if (!interior->hollow) return false;
  return true;
}

}  // namespace

Rgb Shader::shadowed(const Surface& surface, const BuiltLight& light, const LightPath& path, Rgb color) {
  double reach = path.distance - kShadowTolerance;
  if (light.projected_through != nullptr) {
    if (!aperture_end(light, surface, path, reach)) return Rgb(0.0f);
    if (!light.casts_shadows()) return color;
  }
  const bool fog = plan_.fog && light.media_attenuation && light.media_interaction;
  if (reach <= kShadowTolerance && !fog) return color;
  ++context_.counters.shadow_rays;
  const Ray ray{surface.hit.point, path.direction};
  LastBlocker& last = scratch_.last_blockers[light.number][level_ > 1 ? 1 : 0];
  switch (scene_.tree->obstruction(ray, {kShadowTolerance, reach}, last, context_.counters)) {
    case Obstruction::kOpaque: return Rgb(0.0f);
    case Obstruction::kFilter: return filtered(surface, light, path, reach, color);
    case Obstruction::kNone: break;
  }
  return fog ? filtered(surface, light, path, reach, color) : color;
}

// §11.5: only what is nearer than the projection's surface can cast a shadow. False: the ray misses it, so no light comes.
bool Shader::aperture_end(const BuiltLight& light, const Surface& surface, const LightPath& path, double& reach) const {
  Hit hit;
  RayKind kind;
  kind.primary = false;
  kind.shadow = true;
  const Ray ray{surface.hit.point, path.direction};
  if (!light.projected_through->nearest(ray, {kMinimumDepth, path.distance}, kind, hit)) return false;
  reach = hit.t - kShadowTolerance;
  return hit.t < path.distance;
}

// No opaque surface is in the way: the light is filtered by one surface after the other.
Rgb Shader::filtered(const Surface& surface, const BuiltLight& light, const LightPath& path, double reach, Rgb color) {
  const bool fog = plan_.fog && light.media_attenuation && light.media_interaction;
  InteriorList interiors = surface.in.interiors;
  Ray ray{surface.hit.point, path.direction};
  double left = path.distance;
  for (int crossings = 0; crossings < kMaxCrossings; ++crossings) {
    Hit hit;
    if (!scene_.tree->nearest_shadow(ray, {kShadowTolerance, reach}, hit, context_.counters)) {
      if (fog && left > kShadowTolerance && hollow(interiors))
        color *= fog_transmittance(scene_.fogs, settings_.noise_generator, ray, left);
      return color;
    }
    if (hit.leaf->opaque) return Rgb(0.0f);
    color *= shadow_filter(hit, ray, interiors);
    if (nearly_black(color)) return color;
    if (fog && hollow(interiors)) color *= fog_transmittance(scene_.fogs, settings_.noise_generator, ray, hit.t);
    if (!interiors.remove(hit.leaf->interior)) interiors.append(hit.leaf->interior);
    ray.origin = hit.point;
    reach -= hit.t;
    left -= hit.t;
  }
  return Rgb(0.0f);
}

Rgb Shader::shadow_filter(const Hit& hit, const Ray& ray, const InteriorList& interiors) {
  const Leaf& leaf = *hit.leaf;
  bool from_inside = false;
  SurfaceContext context = face_ray(hit, ray, leaf.uv_mapping || plan_.uv_patterns, from_inside);
  Rgb sum{0.0f};
  for_each_texture(hit, leaf, from_inside, [&](const PlacedTexture& texture, float share) {
    const TextureSpace space{.to_world = &*texture.to_world};
    const dvec3 point = texture_point(texture, leaf, hit, context);
    const TextureSpace* outer = texture.to_world.identity() ? nullptr : &space;
    sum += share * texture_filter(*texture.texture, point, outer, leaf, ray.direction, context);
  });
  const BuiltInterior& interior = *leaf.interior;
  const InteriorProperties& p = *interior.properties;
  if (p.fade_power > 0 && std::abs(p.fade_distance) > kColorEpsilon && interiors.contains(&interior))
    sum *= distance_fade(interior, hit.t);
  return sum;
}

Rgb Shader::texture_filter(const CompiledTexture& texture, const dvec3& point, const TextureSpace* space, const Leaf& leaf,
                           const dvec3& to_light, SurfaceContext& context) {
  if (texture.pattern != nullptr) {
    if (texture.entries.empty()) return Rgb(0.0f);
    const TextureSpace inner{.outer = space, .pattern = texture.pattern.get(), .bump_scale = texture.bump_scale};
    const auto entry_filter = [&](const CompiledTexture::Entry& entry, const dvec3& at) {
      return texture_filter(*entry.texture, at, &inner, leaf, to_light, context);
    };
    if (texture.pattern->is_uv_mapping()) return entry_filter(texture.entries.front(), dvec3(context.uv, 0));
    const dvec3 warped = texture.pattern->warp(point);
    if (texture.pattern->is_average()) {
      Rgb sum{0.0f};
      float total = 0;
      for (const auto& entry : texture.entries) {
        sum += entry.position * entry_filter(entry, warped);
        total += entry.position;
      }
      return sum * (1 / total);
    }
    const auto n =
        find_neighbours(std::span<const CompiledTexture::Entry>(texture.entries), texture.pattern->value(warped, context));
    const Rgb current = entry_filter(*n.current, warped);
    if (n.single()) return current;
    return static_cast<float>(1 - n.t) * entry_filter(*n.previous, warped) + static_cast<float>(n.t) * current;
  }
  Rgb filter{1.0f};
  const float caustics = leaf.interior->properties->caustics;
  for (auto layer = texture.layers.rbegin(); layer != texture.layers.rend(); ++layer) {
    Color pigment;
    if (layer->pigment->evaluate(point, context, pigment)) filter *= pass_through(pigment);
    if (caustics == 0) continue;
    dvec3 normal = context.raw_normal;
    if (plan_.normals && layer->normal != nullptr) normal = perturbed(*layer->normal, point, space, context);
    filter *= static_cast<float>(1 + std::pow(std::abs(glm::dot(normal, to_light)), static_cast<double>(caustics)));
  }
  return filter;
}

}  // namespace lute
