#include "engine/texture/pattern/ripples.hpp"

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/wave_sources.hpp"

namespace lute {

double evaluate(const Ripples&, const dvec3& p, const PatternContext& context) {
  double sum = 0;
  for (const dvec3& source : context.waves->positions) {
    const double d = glm::length(p - source);
    sum += cycle_sine((d == 0 ? 1 : d) * context.frequency + context.phase);
  }
  return 0.5 * (1 + sum / static_cast<double>(context.waves->positions.size()));
}

dvec3 perturb(const Ripples&, const dvec3& normal, double amount, const dvec3& p, const PatternContext& context) {
  dvec3 n = normal;
  const auto count = static_cast<double>(context.waves->positions.size());
  for (const dvec3& source : context.waves->positions) {
    const dvec3 away = p - source;
    const double length = glm::length(away), d = length == 0 ? 1 : length;
    n += amount * cycle_sine(d * context.frequency + context.phase) / (d * count) * away;
  }
  return n;
}

}  // namespace lute
