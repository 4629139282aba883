// Mirrors (§8).
#include <algorithm>
#include <cmath>

#include "engine/shade/shader.hpp"

namespace lute {
namespace {

// Fresnel's equations for unpolarised light; 1 beyond the critical angle.
double fresnel(double c, double index) {
  const double q = index * index + c * c - 1;
  if (q <= 0) return 1;
  const double g = std::sqrt(q);
  const double a = (g - c) / (g + c);
  const double b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return std::clamp(0.5 * a * a * (1 + b * b), 0.0, 1.0);
}

Rgb mix(Rgb low, Rgb high, double x) { return static_cast<float>(x) * high + static_cast<float>(1 - x) * low; }

}  // namespace

Rgb Shader::reflectivity(const Surface& surface, const LitLayer& layer, float layer_weight, float& ray_weight) const {
  const Finish& finish = layer.finish;
  const Rgb& low = finish.reflection_min;
  const Rgb& high = finish.reflection_max;
  const double c = -glm::dot(surface.in.ray.direction, layer.normal);
  Rgb amount;
  if (finish.reflection_fresnel) {
    const double index = relative_index(surface);
    amount = index * index + c * c - 1 <= 0 ? high : mix(low, high, fresnel(c, index));
    ray_weight = layer_weight * peak(amount);
  } else {
    double x = 1 - c;
    if (std::abs(finish.reflection_falloff - 1) > kColorEpsilon) x = std::pow(x, static_cast<double>(finish.reflection_falloff));
    amount = std::abs(x) < kEpsilon ? low : std::abs(x - 1) < kEpsilon ? high : mix(low, high, x);
    ray_weight = layer_weight * std::max(peak(high), peak(low));
  }
  if (finish.reflection_metallic != 0) amount *= metallic_tint(layer.pigment.rgb, finish.reflection_metallic, c);
  return amount;
}

double Shader::relative_index(const Surface& surface) const {
  const auto inside = surface.in.interiors.view();
  const double own = static_cast<double>(surface.leaf.interior->properties->ior);
  if (inside.empty()) return own;
  const double outer = static_cast<double>(inside.back()->properties->ior);
  if (!surface.in.interiors.contains(surface.leaf.interior)) return own / outer;
  return inside.size() == 1 ? 1 / own : outer / own;
}

dvec3 mirror_direction(const dvec3& direction, const dvec3& normal, const dvec3& raw_normal) {
  dvec3 mirrored = direction - 2 * glm::dot(direction, normal) * normal;
  // A perturbed normal may send the ray through the surface: turn it back.
  if (glm::dot(mirrored, raw_normal) < 0) {
    if (glm::dot(mirrored, normal) < 0)
      mirrored = direction - 2 * glm::dot(direction, raw_normal) * raw_normal;
    else
      mirrored -= 2 * glm::dot(mirrored, raw_normal) * raw_normal;
  }
  return glm::normalize(mirrored);
}

Color Shader::reflected(const Surface& surface, const Finish& finish, const dvec3& normal, float weight) {
  TracedRay out;
  out.ray.origin = surface.hit.point;
  out.from = surface.hit.leaf;
  out.ray.direction = mirror_direction(surface.in.ray.direction, normal, surface.context.raw_normal);
  out.kind = surface.in.kind;
  out.kind.primary = false;
  out.kind.reflected = true;
  out.monochromatic = surface.in.monochromatic;
  out.wavelength = surface.in.wavelength;
  out.interiors = surface.in.interiors;
  ++context_.counters.reflected_rays;
  Color seen = trace(out, weight);
  if (finish.irid > 0)
    seen.rgb *= iridescence(finish, surface.hit.point, std::abs(glm::dot(normal, out.ray.direction)),
                            std::abs(glm::dot(normal, surface.in.ray.direction)));
  return seen;
}

}  // namespace lute
