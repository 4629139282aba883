#include "engine/texture/compiled_pattern.hpp"

#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {
namespace {

double shape_wave(Wave wave, double v, double exponent) {
  switch (wave) {
    case Wave::kRamp: return v;
    case Wave::kSine: return (1 + cycle_sine(v)) / 2;
    case Wave::kTriangle: return triangle_wave(v);
    case Wave::kScallop: return std::fabs(cycle_sine(v / 2));
    case Wave::kCubic: return v * v * (3 - 2 * v);
    case Wave::kPoly: return std::pow(v, exponent);
  }
  return v;
}

}  // namespace

CompiledPattern::CompiledPattern(const PatternBody& body, const PatternSettings& settings)
    : pattern_(body.pattern),
      chain_(body.warps),
      frequency_(body.frequency),
      phase_(body.phase),
      wave_(body.wave),
      wave_exponent_(body.wave_exponent),
      noise_generator_(body.noise_generator != 0 ? body.noise_generator : settings.noise_generator),
      waves_(settings.waves) {
  if (!chain_.empty())
    if (const auto* classic = std::get_if<ClassicTurbulence>(&chain_.back())) {
      turbulence_ = std::make_shared<Turbulence>(*classic);
      if (const AnyPattern* any = pattern())
        own_turbulence_ = std::visit([](const auto& p) { return std::decay_t<decltype(p)>::kOwnTurbulence; }, *any);
    }
}

PatternContext CompiledPattern::context(const SurfaceContext& surface) const {
  return {.noise_generator = noise_generator_,
          .turbulence = turbulence_.get(),
          .waves = waves_.get(),
          .frequency = frequency_,
          .phase = phase_,
          .normal = surface.normal,
          .ray_direction = surface.ray_direction,
          .uv = surface.uv};
}

double CompiledPattern::value(const dvec3& warped, const SurfaceContext& surface) const {
  const AnyPattern* any = pattern();
  if (any == nullptr) return 0;
  const PatternContext ctx = context(surface);
  double v = std::visit([&](const auto& p) -> double { return evaluate(p, warped, ctx); }, *any);
  // The modulus is a little above 1 so that a raw value of exactly 1 survives.
  if (frequency_ != 0) v = std::fmod(v * static_cast<double>(frequency_) + static_cast<double>(phase_), 1.00001);
  if (v < 0) v -= std::floor(v);
  return shape_wave(wave_, v, static_cast<double>(wave_exponent_));
}

bool CompiledPattern::perturbs_normals() const {
  const AnyPattern* any = pattern();
  return any != nullptr && std::visit(
                               [](const auto& p) {
                                 return requires(dvec3 n, PatternContext c) { lute::perturb(p, n, 0.0, n, c); };
                               },
                               *any);
}

dvec3 CompiledPattern::perturb(const dvec3& normal, double amount, const dvec3& warped, const SurfaceContext& surface) const {
  const PatternContext ctx = context(surface);
  return std::visit(
      [&](const auto& p) {
        if constexpr (requires { lute::perturb(p, normal, amount, warped, ctx); })
          return lute::perturb(p, normal, amount, warped, ctx);
        else
          return normal;
      },
      *pattern());
}

dvec3 CompiledPattern::carry_in(dvec3 normal, bool normalise) const {
  if (normalise) normal = glm::normalize(normal);
  for (const Warp& w : chain_)
    if (const auto* t = std::get_if<Transform>(&w)) normal = glm::transpose(t->linear) * normal;
  return normalise ? glm::normalize(normal) : normal;
}

dvec3 CompiledPattern::carry_out(dvec3 normal, bool normalise) const {
  if (normalise) normal = glm::normalize(normal);
  for (auto w = chain_.rbegin(); w != chain_.rend(); ++w)
    if (const auto* t = std::get_if<Transform>(&*w)) normal = glm::transpose(t->inverse_linear) * normal;
  return normalise ? glm::normalize(normal) : normal;
}

}  // namespace lute
