// Rainbows: colours by the angle between the ray and the bow's axis. Source: specification chapter 40 §14.
#pragma once

#include <span>

#include "engine/build/built_scene.hpp"
#include "engine/shade/random.hpp"

namespace lute {

// Mixes the rainbows into the colour seen at distance `depth`.
void add_rainbows(std::span<const BuiltRainbow> rainbows, const Ray& ray, double depth, SampleRandom& random, Color& color);

}  // namespace lute
