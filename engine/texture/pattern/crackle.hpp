// crackle { form <a,b,c> metric m offset o solid }: cells around random points, one in each unit cube
//
// Value: 0...1, clamped: form (default <-1, 1, 0>) weighs the distances to the three nearest points; with solid, the noise at the
// nearest point. metric (default 2, Euclid; 1 Manhattan) is the exponent of the distance; offset (default 0) is added to distances.
// Source: specification chapter 50 §6.4.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Crackle : PatternDefaults {
  static constexpr std::string_view kKeyword = "crackle";
  dvec3 form{-1, 1, 0};
  double metric = 2;
  double offset = 0;
  bool solid = false;
};

double evaluate(const Crackle& pattern, const dvec3& point, const PatternContext& context);

}  // namespace lute
