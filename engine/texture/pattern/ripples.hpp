// ripples: circular waves from number_of_waves sources
//
// Value: 0...1, the mean of the sources' sines. Normal: tilted along the way from each source. frequency and phase count inside the
// sines, and once more with the wave. The sources: engine/texture/pattern/wave_sources.hpp. No parameters of its own.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Ripples : PatternDefaults {
  static constexpr std::string_view kKeyword = "ripples";
};

double evaluate(const Ripples& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Ripples& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
