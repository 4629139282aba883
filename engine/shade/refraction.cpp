// What is seen through a surface: the list of interiors, bending, total reflection, fading (§9).
#include <algorithm>
#include <cmath>

#include "engine/shade/shader.hpp"

namespace lute {

Rgb Shader::distance_fade(const BuiltInterior& interior, double length) {
  const InteriorProperties& p = *interior.properties;
  const double u = length / static_cast<double>(p.fade_distance);
  const Rgb& c = p.fade_color;
  if (p.fade_power >= 1000) {
    const auto channel = [&](float v) { return static_cast<float>(std::exp(-(1 - static_cast<double>(v)) * u)); };
    return {channel(c.r), channel(c.g), channel(c.b)};
  }
  const float share = static_cast<float>(1 / (1 + std::pow(u, static_cast<double>(p.fade_power))));
  return c + share * (Rgb(1.0f) - c);
}

// §9.1: how the list changes, and the ratio of the indices on both sides.
Shader::Crossing Shader::cross(const Surface& surface) const {
  const BuiltInterior& own = *surface.leaf.interior;
  const double own_ior = static_cast<double>(own.properties->ior);
  const double own_dispersion = static_cast<double>(own.properties->dispersion);
  Crossing c;
  c.interiors = surface.in.interiors;
  c.samples = own.properties->dispersion_samples;
  if (c.interiors.empty()) {
    c.index = 1 / own_ior;
    c.dispersion = 1 / own_dispersion;
    c.interiors.append(&own);
  } else if (c.interiors.back() == &own) {
    c.interiors.remove(&own);
    const BuiltInterior* outer = c.interiors.empty() ? nullptr : c.interiors.back();
    c.index = own_ior / (outer == nullptr ? 1 : static_cast<double>(outer->properties->ior));
    c.dispersion = own_dispersion / (outer == nullptr ? 1 : static_cast<double>(outer->properties->dispersion));
    if (outer != nullptr) c.samples = std::max(c.samples, outer->properties->dispersion_samples);
  } else if (!c.interiors.remove(&own)) {
    const InteriorProperties& outer = *c.interiors.back()->properties;
    c.index = static_cast<double>(outer.ior) / own_ior;
    c.dispersion = static_cast<double>(outer.dispersion) / own_dispersion;
    c.samples = std::max(c.samples, outer.dispersion_samples);
    c.interiors.append(&own);
  }
  return c;
}

Shader::Transmitted Shader::transmitted(const Surface& surface, const Finish& top_finish, const dvec3& top_normal,
                                        float weight) {
  Crossing crossing = cross(surface);
  TracedRay out;
  out.ray.origin = surface.hit.point;
  out.from = surface.hit.leaf;
  out.kind = surface.in.kind;
  out.kind.primary = false;
  out.kind.refracted = true;
  out.monochromatic = surface.in.monochromatic;
  out.wavelength = surface.in.wavelength;
  out.interiors = std::move(crossing.interiors);

  const bool disperses = std::abs(crossing.dispersion - 1) >= kEpsilon;
  if (std::abs(crossing.index - 1) < kEpsilon && !disperses) {
    out.ray.direction = surface.in.ray.direction;
    out.continues = true;
    ++context_.counters.transmitted_rays;
    return {trace(out, weight), false};
  }
  if (disperses && !out.monochromatic) return {dispersed(surface, top_finish, top_normal, out, crossing, weight), false};
  const double index = disperses ? index_at(crossing.index, crossing.dispersion, out.wavelength) : crossing.index;
  return bent(surface, top_finish, top_normal, out, index, weight);
}

Shader::Transmitted Shader::bent(const Surface& surface, const Finish& top_finish, const dvec3& top_normal,
                                 TracedRay& out, double index, float weight) {
  const dvec3& direction = surface.in.ray.direction;
  double c = glm::dot(direction, top_normal);
  const dvec3 normal = c > 0 ? -top_normal : top_normal;
  c = std::abs(c);
  const double t = 1 + index * index * (c * c - 1);
  if (t < 0) return {reflected(surface, top_finish, top_normal, weight), true};
  out.ray.direction = index * direction + (index * c - std::sqrt(t)) * normal;
  ++context_.counters.refracted_rays;
  return {trace(out, weight), false};
}

// One ray for each band of the spectrum. Its transparency is lost.
Color Shader::dispersed(const Surface& surface, const Finish& top_finish, const dvec3& top_normal, TracedRay& out,
                        const Crossing& crossing, float weight) {
  Rgb sum{0.0f};
  out.monochromatic = true;
  for (int i = 0; i < crossing.samples; ++i) {
    out.wavelength = 380 + 350 * (i + 0.5) / crossing.samples;
    const double index = index_at(crossing.index, crossing.dispersion, out.wavelength);
    sum += bent(surface, top_finish, top_normal, out, index, weight).color.rgb * band_color(out.wavelength, crossing.samples);
  }
  return {sum * (1 / static_cast<float>(crossing.samples)), 0, 0};
}

}  // namespace lute
