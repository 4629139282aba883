// Phong and specular highlights, metallic tint, iridescence (§7 steps 8-9).
#include <algorithm>
#include <cmath>

#include "engine/shade/shader.hpp"
#include "engine/texture/noise.hpp"

namespace lute {

Rgb metallic_tint(Rgb pigment, float metallic, double c) {
  const double x = std::abs(std::acos(std::clamp(c, -1.0, 1.0))) / (kPi / 2);
  const double fresnel = std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
  return Rgb(1.0f) + (metallic * static_cast<float>(1 - fresnel)) * (pigment - Rgb(1.0f));
}

namespace {

// c^exponent for c up to 1. What is below e^-40 adds nothing that a float beside it could hold.
double lobe(double c, double exponent) { return (1 - c) * exponent > 40 ? 0 : std::pow(c, exponent); }

}  // namespace

Rgb Shader::highlights(const Surface& surface, const LitLayer& layer, const dvec3& to_light, Rgb color) const {
  const Finish& finish = layer.finish;
  const dvec3& direction = surface.in.ray.direction;
  double intensity = 0;
  if (finish.phong > 0) {
    const dvec3 mirrored = direction - 2 * glm::dot(direction, layer.normal) * layer.normal;
    const double c = glm::dot(mirrored, to_light);
    // Below, a power of 60 and more is as good as nothing.
    if (c > 0 && (finish.phong_size < 60 || c > 0.0008))
      intensity += static_cast<double>(finish.phong) * lobe(c, static_cast<double>(finish.phong_size));
  }
  if (finish.specular > 0) {
    const dvec3 half = to_light - direction;
    const double length = glm::length(half);
    const double c = length > 0 ? glm::dot(half, layer.normal) / length : 0;
    if (c > 0) intensity += static_cast<double>(finish.specular) * lobe(c, static_cast<double>(finish.specular_exponent));
  }
  if (intensity == 0) return Rgb(0.0f);
  const Rgb light = color * static_cast<float>(intensity);
  return finish.metallic > 0 ? light * metallic_tint(layer.pigment.rgb, finish.metallic, glm::dot(layer.normal, to_light)) : light;
}

Rgb Shader::iridescence(const Finish& finish, const dvec3& point, double cos_light, double cos_view) const {
  double thickness = static_cast<double>(finish.irid_thickness);
  if (finish.irid_turbulence != 0) {
    Turbulence film;
    film.octaves = 5;
    film.omega = 0.5f;
    film.lambda = 2;
    const double q = turbulence(point, film, settings_.noise_generator);
    thickness *= 1 + static_cast<double>(finish.irid_turbulence) * (2 * q - 1);
  }
  const double phase = 2 * kPi * thickness * (cos_light + cos_view);
  const auto channel = [&](float wavelength) {
    return 1 + finish.irid * static_cast<float>(std::cos(phase / static_cast<double>(wavelength)));
  };
  const Rgb& w = settings_.irid_wavelength;
  return {channel(w.r), channel(w.g), channel(w.b)};
}

}  // namespace lute
