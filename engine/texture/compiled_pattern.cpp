#include "engine/texture/compiled_pattern.hpp"

#include <cmath>

#include "engine/math/rounding.hpp"
#include "engine/texture/noise.hpp"
#include "engine/texture/texture_compiler.hpp"

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

CompiledPattern::CompiledPattern(const PatternBody& body, TextureCompiler& compiler)
    : pattern_(body.pattern),
      frequency_(static_cast<double>(body.frequency)),
      phase_(static_cast<double>(body.phase)),
      wave_(body.wave),
      wave_exponent_(static_cast<double>(body.wave_exponent)) {
  const PatternSettings& settings = compiler.pattern_settings();
  context_.noise_generator = body.noise_generator != 0 ? body.noise_generator : settings.noise_generator;
  context_.frequency = body.frequency;
  context_.phase = body.phase;
  waves_ = settings.waves;
  context_.waves = waves_.get();
  take_warps(body.warps);
  if (const AnyPattern* any = pattern()) find_resources(*any, compiler);
}

void CompiledPattern::take_warps(const WarpChain& warps) {
  bool own_turbulence = false;
  if (const AnyPattern* any = pattern())
    own_turbulence = std::visit([](const auto& p) { return std::decay_t<decltype(p)>::kOwnTurbulence; }, *any);
  for (const Warp& w : warps) {
    if (const auto* transform = std::get_if<Transform>(&w); transform != nullptr && transform->identity()) continue;
    if (const auto* warp = std::get_if<TurbulenceWarp>(&w); warp != nullptr && warp->amount == dvec3(0)) continue;
    if (const auto* classic = std::get_if<ClassicTurbulence>(&w)) {
      turbulence_ = *classic;
      if (own_turbulence || classic->amount == dvec3(0)) continue;
    }
    chain_.push_back(w);
  }
  if (turbulence_) context_.turbulence = &*turbulence_;
}

void CompiledPattern::find_resources(const AnyPattern& any, TextureCompiler& compiler) {
  if (const auto* object = std::get_if<ObjectPattern>(&any)) {
    inside_test_ = compiler.inside_test(object->object);
    context_.inside_test = inside_test_.get();
  }
  if (const auto* pigment = std::get_if<PigmentPattern>(&any)) context_.pigment = compiler.pigment(pigment->pigment);
}

double CompiledPattern::value(const dvec3& warped, const SurfaceContext& surface) const {
  const AnyPattern* any = pattern();
  if (any == nullptr) return 0;
  PatternContext context = context_;
  context.surface = &surface;
  double v = std::visit([&](const auto& p) -> double { return evaluate(p, warped, context); }, *any);
  if (frequency_ != 0) v = within_pattern_period(v * frequency_ + phase_);
  if (v < 0) v -= fast_floor(v);
  return shape_wave(wave_, v, wave_exponent_);
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
  PatternContext context = context_;
  context.surface = &surface;
  return std::visit(
      [&](const auto& p) {
        if constexpr (requires { lute::perturb(p, normal, amount, warped, context); })
          return lute::perturb(p, normal, amount, warped, context);
        else
          return normal;
      },
      *pattern());
}

dvec3 CompiledPattern::carry_in(dvec3 normal, bool normalise) const {
  if (normalise) normal = glm::normalize(normal);
  bool carried = false;
  for (const Warp& w : chain_)
    if (const auto* t = std::get_if<Transform>(&w)) {
      normal = glm::transpose(t->linear) * normal;
      carried = true;
    }
  return normalise && carried ? glm::normalize(normal) : normal;
}

dvec3 CompiledPattern::carry_out(dvec3 normal, bool normalise) const {
  if (normalise) normal = glm::normalize(normal);
  bool carried = false;
  for (auto w = chain_.rbegin(); w != chain_.rend(); ++w)
    if (const auto* t = std::get_if<Transform>(&*w)) {
      normal = glm::transpose(t->inverse_linear) * normal;
      carried = true;
    }
  return normalise && carried ? glm::normalize(normal) : normal;
}

}  // namespace lute
