// From a hit to its textures (§4).
#include "engine/shade/shader.hpp"
#include "engine/texture/blend.hpp"

namespace lute {
namespace {

// A normal taken through all enclosing spaces, the outermost first. Each has its own texture's bump scale; that of the object's
// texture is a part of the next one within, which is `within` where no pattern encloses the layer.
dvec3 carry_in(const TextureSpace* space, dvec3 normal, bool within) {
  if (space == nullptr) return normal;
  if (space->pattern == nullptr) {
    const dvec3 carried = space->to_world->inverse_normal(normal);
    return within ? glm::normalize(carried) : carried;
  }
  return space->pattern->carry_in(carry_in(space->outer, normal, space->bump_scale), space->bump_scale);
}

// As the reference does, an outermost pattern without bump scale leaves the normal as long as it has become: the surface is lit by it so.
dvec3 carry_out(const TextureSpace* space, dvec3 normal) {
  bool unit = true;
  for (; space != nullptr; space = space->outer) {
    if (space->pattern != nullptr) {
      normal = space->pattern->carry_out(normal, space->bump_scale);
      unit = space->bump_scale;
    } else {
      normal = glm::transpose(space->to_world->inverse_linear) * normal;
    }
  }
  return unit ? glm::normalize(normal) : normal;
}

}  // namespace

SurfaceContext Shader::face_ray(const Hit& hit, const Ray& ray, bool wants_uv, bool& from_inside) {
  const Leaf& leaf = *hit.leaf;
  dvec3 normal = leaf.shape->normal(hit.shape_hit, hit.point);
  if (leaf.inverted) normal = -normal;
  from_inside = glm::dot(normal, ray.direction) > 0;
  if (from_inside) normal = -normal;
  return {.point = hit.point,
          .raw_normal = normal,
          .normal = normal,
          .ray_direction = ray.direction,
          .uv = wants_uv ? leaf.shape->uv(hit.shape_hit, hit.point) : dvec2(0),
          .has_surface = true};
}

dvec3 Shader::texture_point(const PlacedTexture& texture, const Leaf& leaf, const Hit& hit, const SurfaceContext& context) {
  const dvec3 point = leaf.uv_mapping ? dvec3(context.uv, 0) : hit.point;
  return texture.to_world.identity() ? point : texture.to_world->inverse_point(point);
}

Color Shader::shade(const TracedRay& ray, const Hit& hit, float weight) {
  const Leaf& leaf = *hit.leaf;
  ScratchBlock<LightAtPoint> lights(scratch_.lights, light_count(leaf));
  for (std::size_t i = 0; i < lights.size(); ++i) lights[i].reached = lights[i].shadowed = false;
  bool from_inside = false;
  Surface surface{.in = ray, .hit = hit, .leaf = leaf, .weight = weight,
                  .context = face_ray(hit, ray.ray, leaf.uv_mapping || plan_.uv_patterns, from_inside), .lights = &lights};

  Color sum;
  const bool weighted = leaf.has_part_textures() || leaf.texture.texture == nullptr;
  for_each_texture(hit, leaf, from_inside, [&](const PlacedTexture& texture, float share) {
    if (weighted && share < settings_.adc_bailout) return;
    const TextureSpace space{.to_world = &*texture.to_world};
    const dvec3 point = texture_point(texture, leaf, hit, surface.context);
    const Color c = texture_color(surface, *texture.texture, point, texture.to_world.identity() ? nullptr : &space);
    if (weighted) {
      sum.rgb += share * c.rgb;
      sum.transmit += share * c.transmit;
    } else {
      sum = c;
    }
  });
  return sum;
}

// §4.1.
Color Shader::texture_color(Surface& surface, const CompiledTexture& texture, const dvec3& point, const TextureSpace* space) {
  if (texture.pattern == nullptr) return layers_color(surface, texture, point, space);
  if (texture.entries.empty()) return {};
  const TextureSpace inner{.outer = space, .pattern = texture.pattern.get(), .bump_scale = texture.bump_scale};
  if (texture.pattern->is_uv_mapping())
    return texture_color(surface, *texture.entries.front().texture, dvec3(surface.context.uv, 0), &inner);

  const dvec3 warped = texture.pattern->warp(point);
  if (texture.pattern->is_average()) {
    Color sum;
    float total = 0;
    for (const auto& entry : texture.entries) {
      sum += texture_color(surface, *entry.texture, warped, &inner) * entry.position;
      total += entry.position;
    }
    return sum * (1 / total);
  }
  const auto n = find_neighbours(std::span<const CompiledTexture::Entry>(texture.entries),
                                 texture.pattern->value(warped, surface.context));
  const Color current = texture_color(surface, *n.current->texture, warped, &inner);
  if (n.single()) return current;
  const Color previous = texture_color(surface, *n.previous->texture, warped, &inner);
  return previous * static_cast<float>(1 - n.t) + current * static_cast<float>(n.t);
}

// The normal that a layer's pattern makes of the raw one. Patterns that ask for the surface's normal see it from then on, in the space of the
// enclosing texture and as long as it has become.
dvec3 Shader::perturbed(const CompiledNormal& normal, const dvec3& point, const TextureSpace* space, SurfaceContext& context) {
  if (normal.is_uv_mapping() && space != nullptr && space->pattern == nullptr) space = nullptr;
  const dvec3 bent = normal.bend(carry_in(space, context.raw_normal, normal.bump_scale()), point, context);
  context.normal = bent;
  const dvec3 unit = normal.bump_scale() ? bent : glm::normalize(bent);
  return space == nullptr ? unit : carry_out(space, unit);
}

}  // namespace lute
