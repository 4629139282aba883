#include "engine/shade/fog.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {
namespace {

// Mean density of ground fog between two heights, in units of fog_alt above the offset: the integral of 1 / (1 + y^2).
double mean_density(double y1, double y2) {
  if (y1 <= 0 && y2 <= 0) return 1;
  if (y1 <= 0) return (std::atan(y2) - y1) / (y2 - y1);
  if (y2 <= 0) return (std::atan(y1) - y2) / (y1 - y2);
  return std::abs(y1 - y2) > kEpsilon ? (std::atan(y1) - std::atan(y2)) / (y1 - y2) : 1 / (y1 * y1 + 1);
}

double fog_depth(const Fog& fog, int noise_generator, const Ray& ray, double length) {
  if (!fog.turbulence) return length;
  const dvec3 middle = ray.at(length / 2) * fog.turbulence->amount;
  const double z = turbulence(middle, *fog.turbulence, noise_generator);
  return length * (1 - std::exp(-length / fog.distance) * std::min(1.0, z * fog.turbulence_depth));
}

// The share of light that passes straight through.
float passing(const Fog& fog, int noise_generator, const Ray& ray, double length) {
  double depth = fog_depth(fog, noise_generator, ray, length);
  if (fog.type == 2) {
    const double y1 = (glm::dot(ray.origin, fog.up) - fog.offset) / fog.altitude;
    const double y2 = (glm::dot(ray.at(length), fog.up) - fog.offset) / fog.altitude;
    depth *= mean_density(y1, y2);
  }
  return std::max(static_cast<float>(std::exp(-depth / fog.distance)), fog.color.transmit);
}

Rgb tint(const Fog& fog, float passed) {
  return passed * (Rgb(1 - fog.color.filter) + fog.color.filter * fog.color.rgb);
}

}  // namespace

void add_fogs(std::span<const Fog> fogs, int noise_generator, const Ray& ray, double length, Color& color) {
  Rgb dimmed{1.0f}, light{0.0f};
  for (const Fog& fog : fogs) {
    const float passed = passing(fog, noise_generator, ray, length);
    dimmed *= tint(fog, passed);
    light += (1 - passed) * fog.color.rgb;
  }
  color.rgb = light + dimmed * color.rgb;
  color.transmit *= grey(dimmed);
}

Rgb fog_transmittance(std::span<const Fog> fogs, int noise_generator, const Ray& ray, double length) {
  Rgb dimmed{1.0f};
  for (const Fog& fog : fogs) dimmed *= tint(fog, passing(fog, noise_generator, ray, length));
  return dimmed;
}

}  // namespace lute
