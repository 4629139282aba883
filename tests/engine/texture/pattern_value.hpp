// The value of a pattern at a point, all of chapter 50 §4: warps, formula, frequency and wave.
#pragma once

#include "engine/texture/texture_compiler.hpp"

namespace lute {

template <class Pattern>
PatternBody body_of(const Pattern& pattern) {
  PatternBody body;
  body.pattern = AnyPattern(pattern);
  body.frequency = Pattern::kFrequency;
  body.wave = Pattern::kWave;
  return body;
}

inline double value_at(const PatternBody& body, const dvec3& point, const SurfaceContext& surface = {}) {
  TextureCompiler compiler{TextureSettings()};
  const CompiledPattern pattern(body, compiler);
  return pattern.value(pattern.warp(point), surface);
}

}  // namespace lute
