// The layers of a plain texture, from the top down (§5).
#include <algorithm>
#include <cmath>

#include "engine/shade/shader.hpp"

namespace lute {
namespace {

float layer_opacity(const Color& pigment, bool legacy) {
  return legacy ? 1 - (pigment.filter * peak(pigment.rgb) + pigment.transmit) : opacity(pigment);
}

bool same_normal(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon && std::abs(a.z - b.z) < kEpsilon;
}

Rgb power(Rgb c, float exponent) { return {std::pow(c.r, exponent), std::pow(c.g, exponent), std::pow(c.b, exponent)}; }

// `filter`: what the layers so far let through of the light from below.
void add_filter(const Color& pigment, const Finish& finish, Rgb reflectivity, Rgb& filter) {
  filter *= pass_through(pigment);
  if (!finish.conserve_energy) return;
  const Rgb kept = Rgb(1.0f) - reflectivity;
  filter *= Rgb(std::min(1.0f, kept.r), std::min(1.0f, kept.g), std::min(1.0f, kept.b));
}

}  // namespace

Color Shader::layers_color(Surface& surface, const CompiledTexture& texture, const dvec3& point, const TextureSpace* space) {
  Color color;
  Rgb filter{1.0f};
  float translucency = 1;
  bool pigment_found = false;
  dvec3 top_normal = surface.context.raw_normal;
  ScratchBlock<ReflectingLayer> reflections(scratch_.reflections);

  for (auto layer = texture.layers.rbegin(); layer != texture.layers.rend() && translucency > settings_.adc_bailout; ++layer) {
    const Finish& finish = *layer->finish;
    dvec3 normal = surface.context.raw_normal;
    if (plan_.normals && layer->normal != nullptr) normal = perturbed(*layer->normal, point, space, surface.context);
    if (layer == texture.layers.rbegin()) top_normal = normal;

    Color pigment;
    const bool found = layer->pigment->evaluate(point, surface.context, pigment);
    if (!found) pigment = {};
    pigment_found = pigment_found || found;

    float reflected_weight = 0;
    Rgb reflectivity_here{0.0f};
    if (settings_.quality < kQualityLights) {
      color = {pigment.rgb, 0, 0};
    } else {
      const LitLayer lit{finish, pigment, layer_opacity(pigment, settings_.legacy), normal};
      if (plan_.reflection && layer->reflects) {
        reflectivity_here = reflectivity(surface, lit, surface.weight * translucency, reflected_weight);
        if (!(reflectivity_here == Rgb(0.0f)))
          scratch_.reflections.push({reflectivity_here, reflected_weight, normal, &finish});
      }
      color.rgb += own_light(surface, lit) * filter;
    }
    if (found) add_filter(pigment, finish, reflectivity_here, filter);
    translucency = std::min(1.0f, std::abs(grey(filter)));
  }

  bool total_reflection = false;
  if (plan_.transmission && translucency > settings_.adc_bailout && !texture.layers.empty())
    total_reflection = add_transmission(surface, *texture.layers.back().finish, top_normal, filter, translucency, pigment_found, color);
  if (reflections.size() > 0) add_reflections(surface, top_normal, total_reflection, reflections, color);
  return color;
}

// What the layer sends toward the ray by itself: ambient light, emission, and the light that falls on it.
Rgb Shader::own_light(Surface& surface, const LitLayer& layer) {
  const Finish& finish = layer.finish;
  Rgb light = layer.pigment.rgb * (finish.ambient * settings_.ambient_light + finish.emission) * layer.opacity;
  if (plan_.lights) light += direct_light(surface, layer);
  return light;
}

bool Shader::add_transmission(Surface& surface, const Finish& top_finish, const dvec3& top_normal, Rgb filter,
                              float translucency, bool pigment_found, Color& color) {
  const float strongest = std::max({std::abs(filter.r), std::abs(filter.g), std::abs(filter.b)});
  const Transmitted seen = transmitted(surface, top_finish, top_normal, surface.weight * strongest);
  const BuiltInterior& interior = *surface.leaf.interior;
  Rgb attenuation(interior.properties->refraction);
  if (std::abs(interior.properties->fade_distance) > kColorEpsilon && surface.in.interiors.contains(&interior))
    attenuation *= distance_fade(interior, surface.hit.t);

  color.rgb += attenuation * seen.color.rgb * (seen.total_reflection || !pigment_found ? Rgb(1.0f) : filter);
  if (!seen.total_reflection) color.transmit = grey(attenuation) * seen.color.transmit * (pigment_found ? translucency : 1.0f);
  return seen.total_reflection;
}

void Shader::add_reflections(Surface& surface, const dvec3& top_normal, bool total_reflection,
                             ScratchBlock<ReflectingLayer>& layers, Color& color) {
  const std::size_t count = layers.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ReflectingLayer layer = layers[i];  // a copy: deeper rays use the same stack
    if (total_reflection && same_normal(layer.normal, top_normal)) continue;
    Rgb seen = reflected(surface, *layer.finish, layer.normal, layer.weight).rgb;
    if (layer.finish->reflection_exponent != 1) seen = power(seen, layer.finish->reflection_exponent);
    color.rgb += layer.amount * seen;
  }
}

}  // namespace lute
