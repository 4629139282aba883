// Fog: constant and ground fog over a stretch of a ray. Source: specification chapter 40 §13.
#pragma once

#include <span>

#include "engine/image/color.hpp"
#include "engine/math/ray.hpp"
#include "engine/scene/atmosphere.hpp"

namespace lute {

// Mixes the fogs' light into the colour seen at `length`; its transmit is dimmed too.
void add_fogs(std::span<const Fog> fogs, int noise_generator, const Ray& ray, double length, Color& color);

// What the fogs leave of light that travels `length` along the ray.
Rgb fog_transmittance(std::span<const Fog> fogs, int noise_generator, const Ray& ray, double length);

}  // namespace lute
