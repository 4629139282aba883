// A pattern ready to be evaluated: its warps, the pattern itself, frequency and wave (specification chapter 50 §4).
#pragma once

#include <memory>
#include <optional>

#include "engine/scene/texture.hpp"
#include "engine/texture/inside_test.hpp"
#include "engine/texture/pattern/wave_sources.hpp"
#include "engine/texture/surface_context.hpp"

namespace lute {

class TextureCompiler;

// What all patterns of a scene have in common.
struct PatternSettings {
  int noise_generator = 2;
  std::shared_ptr<const WaveSources> waves;
};

class CompiledPattern {
 public:
  CompiledPattern(const PatternBody& body, TextureCompiler& compiler);
  CompiledPattern(const CompiledPattern&) = delete;
  CompiledPattern& operator=(const CompiledPattern&) = delete;

  // The point after the chain of warps, its coordinates bounded.
  dvec3 warp(const dvec3& point) const { return bounded_coordinates(chain_.empty() ? point : apply_warps(chain_, point, false)); }
  // The pattern's value at a warped point, wave included. The point is one that warp() gave, or is bounded like it.
  double value(const dvec3& warped, const SurfaceContext& surface) const;

  const AnyPattern* pattern() const { return std::get_if<AnyPattern>(&pattern_); }
  bool is_average() const { return std::holds_alternative<Average>(pattern_); }
  bool is_uv_mapping() const { return std::holds_alternative<UvMapping>(pattern_); }

  // True if the pattern perturbs normals by a formula of its own.
  bool perturbs_normals() const;
  dvec3 perturb(const dvec3& normal, double amount, const dvec3& warped, const SurfaceContext& surface) const;

  // The transformations of the chain carry a normal into pattern space, and back (chapter 50 §13.1).
  dvec3 carry_in(dvec3 normal, bool normalise) const;
  dvec3 carry_out(dvec3 normal, bool normalise) const;

 private:
  void take_warps(const WarpChain& warps);
  void find_resources(const AnyPattern& any, TextureCompiler& compiler);

  std::variant<NoPattern, Average, UvMapping, AnyPattern> pattern_;
  WarpChain chain_;  // without what has no effect on the point
  double frequency_, phase_;
  Wave wave_;
  double wave_exponent_;
  PatternContext context_;                // all but the surface
  std::optional<Turbulence> turbulence_;  // the classic one, if the chain ends with it
  std::shared_ptr<const WaveSources> waves_;
  std::shared_ptr<const InsideTest> inside_test_;
};

}  // namespace lute
