#include "engine/texture/pattern/waves.hpp"

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/wave_sources.hpp"

namespace lute {

double evaluate(const Waves&, const dvec3& p, const PatternContext& context) {
  double sum = 0;
  const auto& [positions, frequencies] = *context.waves;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double d = glm::length(p - positions[i]);
    sum += cycle_sine((d == 0 ? 1 : d) * context.frequency * frequencies[i] + context.phase) / frequencies[i];
  }
  return 0.2 * (2.5 + sum / static_cast<double>(positions.size()));
}

dvec3 perturb(const Waves&, const dvec3& normal, double amount, const dvec3& p, const PatternContext& context) {
  dvec3 n = normal;
  const auto& [positions, frequencies] = *context.waves;
  const auto count = static_cast<double>(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const dvec3 away = p - positions[i];
    const double length = glm::length(away), d = length == 0 ? 1 : length;
    n += amount * cycle_sine(d * context.frequency * frequencies[i] + context.phase) / (frequencies[i] * d * count) *
         away;
  }
  return n;
}

}  // namespace lute
