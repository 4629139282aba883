// waves: circular waves of different frequencies
//
// Value: about 0...1, 0.5 + 0.2 times the mean of the sources' sines, each divided by its frequency. Normal: tilted along the way from
// each source. frequency and phase as for ripples. No parameters of its own.
// Source: specification chapter 50 §6, §13.2.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Waves : PatternDefaults {
  static constexpr std::string_view kKeyword = "waves";
};

double evaluate(const Waves& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Waves& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
