// facets { size s coords c metric m }, normals only: flat faces around random points
//
// Value (in a normal_map): 0. size (default 0.1) is that of the faces, below 1e-6 counts as 1e-6. coords c = 0 (default): faces of the
// directions, the normal is replaced; otherwise faces of space, which tilt it by c. metric (default 2): exponent of the distance.
// The amount does not count.
// Source: specification chapter 50 §13.5.
#pragma once

#include "engine/texture/pattern/pattern.hpp"

namespace lute {

struct Facets : PatternDefaults {
  static constexpr std::string_view kKeyword = "facets";
  float size = 0.1f;
  float coords = 0;
  double metric = 2;
};

double evaluate(const Facets& pattern, const dvec3& point, const PatternContext& context);
dvec3 perturb(const Facets& pattern, const dvec3& normal, double amount, const dvec3& point, const PatternContext& context);

}  // namespace lute
