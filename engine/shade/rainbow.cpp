#include "engine/shade/rainbow.hpp"

#include <algorithm>
#include <cmath>

#include "engine/texture/blend.hpp"

namespace lute {
namespace {

Color color_at(const BuiltRainbow& rainbow, double i) {
  const auto n = find_neighbours(std::span<const ColorMap::Entry>(rainbow.colors), i);
  if (n.single()) return n.current->value;
  return n.previous->value * static_cast<float>(1 - n.t) + n.current->value * static_cast<float>(n.t);
}

// Where the ray stands on the bow: its place across the colours, and how far the bow has faded along its arc. False: beside it.
bool place_on_bow(const BuiltRainbow& bow, const dvec3& direction, SampleRandom& random, double& across, double& fade) {
  const double x = glm::dot(direction, bow.right);
  double y = glm::dot(direction, bow.up);
  const double length = x * x + y * y;
  if (length > 0) y /= std::sqrt(length);
  const double along = std::abs(std::acos(std::clamp(y, -1.0, 1.0)));
  if (along > bow.arc) return false;
  const double forward = glm::dot(direction, bow.axis);
  if (forward < 0) return false;
  across = (std::acos(std::min(1.0, forward)) - bow.start) / bow.width;
  if (bow.jitter > 0) across += (2 * random.next() - 1) * bow.jitter;
  if (!(across >= 0 && across <= 1 - kEpsilon)) return false;
  fade = 0;
  if (bow.arc > bow.falloff && along > bow.falloff) {
    const double e = (along - bow.falloff) / (bow.arc - bow.falloff);
    fade = e * e * (3 - 2 * e);
  }
  return true;
}

}  // namespace

void add_rainbows(std::span<const BuiltRainbow> rainbows, const Ray& ray, double depth, SampleRandom& random, Color& color) {
  Rgb sum{0.0f};
  float filter = 1, transmit = 1;
  int count = 0;
  for (const BuiltRainbow& bow : rainbows) {
    double across = 0, fade = 0;
    if (!place_on_bow(bow, ray.direction, random, across, fade)) continue;
    const Color c = color_at(bow, across);
    const float faded = static_cast<float>(fade);
    const float k = std::max(static_cast<float>(std::exp(-depth / bow.distance)), faded * (1 - c.transmit) + c.transmit);
    const float g = c.filter * (1 - k);
    sum += k * color.rgb * (Rgb(1 - g) + g * c.rgb) + (1 - k) * c.rgb;
    filter *= k * c.filter;
    transmit *= k * c.transmit;
    ++count;
  }
  if (count == 0) return;
  color.rgb = sum * (1 / static_cast<float>(count));
  color.filter *= filter;
  color.transmit *= transmit;
}

}  // namespace lute
