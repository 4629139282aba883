#include "engine/texture/pattern/facets.hpp"

#include "engine/texture/noise.hpp"
#include "engine/texture/pattern/feature_points.hpp"

namespace lute {

// Facets exist as a normal only; as a height they are flat.
double evaluate(const Facets&, const dvec3&, const PatternContext&) { return 0; }

dvec3 perturb(const Facets& pattern, const dvec3& normal, double, const dvec3& p, const PatternContext&) {
  const dvec3 n = glm::normalize(normal);
  const double size = static_cast<double>(pattern.size), coords = static_cast<double>(pattern.coords);
  const double scale = size < 1e-6 ? 1e6 : 1 / size;
  const dvec3 q = facet_point((coords != 0 ? p : n) * scale, pattern.metric);
  if (coords == 0) return q;
  const dvec3 e = vector_noise(q);
  return n + coords * (e - glm::dot(e, n) * n);
}

}  // namespace lute
