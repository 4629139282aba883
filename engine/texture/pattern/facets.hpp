// facets { size s coords c metric m }, normals only: flat faces around random points (specification chapter 50 §13.5).
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
