// Light that falls on a layer straight from the light sources (§7).
#include <cmath>

#include "engine/light/area.hpp"
#include "engine/shade/shader.hpp"

namespace lute {
namespace {

bool takes_light(const Finish& f) { return f.diffuse != 0 || f.diffuse_back != 0 || f.phong != 0 || f.specular != 0; }

}  // namespace

// First the lights of the whole scene, then those of the object's group.
std::array<Shader::Lights, 2> Shader::lights_of(const Leaf& leaf) const {
  return {leaf.global_lights ? Lights(scene_.global_lights) : Lights(),
          leaf.light_group >= 0 ? Lights(scene_.light_groups[static_cast<std::size_t>(leaf.light_group)].lights) : Lights()};
}

std::size_t Shader::light_count(const Leaf& leaf) const {
  std::size_t count = 0;
  for (const Lights lights : lights_of(leaf)) count += lights.size();
  return count;
}

// All of what one light takes is one function to the compiler: calls would cost more than what most of them do.
[[gnu::flatten]] Rgb Shader::direct_light(Surface& surface, const LitLayer& layer) {
  Rgb sum{0.0f};
  if (!takes_light(layer.finish) || surface.lights->size() == 0) return sum;
  // No further ray is shaded from here on: the entries of the stack stay where they are.
  LightAtPoint* known = &(*surface.lights)[0];
  for (const Lights lights : lights_of(surface.leaf))
    for (const BuiltLight* light : lights) sum += light_from(surface, layer, *light, *known++);
  return sum;
}

Rgb Shader::light_from(const Surface& surface, const LitLayer& layer, const BuiltLight& source, LightAtPoint& known) {
  const bool area_lit = source.area && source.area->illumination;
  if (!known.reached) {
    known.reached = true;
    known.path = path_to(source, source.location, surface.hit.point);
    known.color = source.color;
    if (!area_lit && source.attenuates()) known.color *= static_cast<float>(attenuation(source, surface.hit.point, known.path));
  }
  if (nearly_black(known.color)) return Rgb(0.0f);
  const LightPath& path = known.path;
  bool backside = false;
  if (!surface.leaf.double_illuminate && !area_lit && glm::dot(layer.normal, path.direction) < kEpsilon) {
    if (layer.finish.diffuse_back == 0) return Rgb(0.0f);
    backside = true;
  }
  const Rgb color = after_shadows(surface, source, known);
  if (nearly_black(color)) return Rgb(0.0f);

  Rgb result = area_lit ? area_illumination(surface, layer, source, path.direction, color)
                        : scattered(surface, layer, source, path.direction, color, backside);
  if (layer.finish.irid > 0)
    result *= iridescence(layer.finish, surface.hit.point, std::abs(glm::dot(layer.normal, path.direction)),
                          std::abs(glm::dot(layer.normal, surface.in.ray.direction)));
  return result;
}

// The same for all layers and blended textures of the point.
Rgb Shader::after_shadows(const Surface& surface, const BuiltLight& source, LightAtPoint& known) {
  if (!plan_.shadows) return known.color;
  if (known.shadowed) return known.after_shadows;
  known.shadowed = true;
  known.after_shadows = known.color;
  if (source.area && source.casts_shadows())
    known.after_shadows = area_shadow(surface, source, known.path.direction, known.color);
  else if (source.casts_shadows() || source.projected_through != nullptr)
    known.after_shadows = shadowed(surface, source, known.path, known.color);
  return known.after_shadows;
}

Rgb Shader::scattered(const Surface& surface, const LitLayer& layer, const BuiltLight& source, const dvec3& to_light, Rgb color,
                      bool backside) {
  return plan_.highlights ? diffused_and_shining(surface, layer, source, to_light, color, backside)
                          : diffused(layer, to_light, color, backside);
}

Rgb Shader::diffused(const LitLayer& layer, const dvec3& to_light, Rgb color, bool backside) {
  const Finish& finish = layer.finish;
  const float k = backside ? finish.diffuse_back : finish.diffuse;
  if (!(k > 0)) return Rgb(0.0f);
  double intensity = std::abs(glm::dot(layer.normal, to_light));
  if (finish.brilliance != 1) intensity = std::pow(intensity, static_cast<double>(finish.brilliance));
  float i = static_cast<float>(intensity) * k * layer.opacity;
  if (finish.crand > 0) i -= static_cast<float>(context_.random.next()) * finish.crand;
  return i * layer.pigment.rgb * color;
}

// Apart, so that scenes without highlights need not keep at every light what these take.
[[gnu::noinline]] Rgb Shader::diffused_and_shining(const Surface& surface, const LitLayer& layer, const BuiltLight& source,
                                                   const dvec3& to_light, Rgb color, bool backside) {
  Rgb result = diffused(layer, to_light, color, backside);
  if (layer.finish.shines() && !backside && source.has_highlights() && !surface.in.kind.radiosity)
    result += highlights(surface, layer, to_light, color);
  return result;
}

// §10.4: every sample of the area lights the point by itself; shadows are those of the area as a whole.
Rgb Shader::area_illumination(const Surface& surface, const LitLayer& layer, const BuiltLight& source, const dvec3& to_center, Rgb color) {
  const AreaAxes axes = area_axes(source, to_center);
  Rgb sum{0.0f};
  const AreaLight& area = *source.area;
  for (int v = 0; v < area.size2; ++v) {
    for (int u = 0; u < area.size1; ++u) {
      const double du = area.jitter ? context_.random.next() - 0.5 : 0;
      const double dv = area.jitter ? context_.random.next() - 0.5 : 0;
      const LightPath path = path_to(source, source.location + area_offset(area, axes, u + du, v + dv), surface.hit.point);
      bool backside = false;
      if (!surface.leaf.double_illuminate && glm::dot(layer.normal, path.direction) < kEpsilon) {
        if (layer.finish.diffuse_back == 0) continue;
        backside = true;
      }
      const float factor = static_cast<float>(attenuation(source, surface.hit.point, path));
      sum += scattered(surface, layer, source, path.direction, color * factor, backside);
    }
  }
  return sum * (1 / static_cast<float>(area.size1 * area.size2));
}

}  // namespace lute
