#include "engine/texture/pattern/quilted.hpp"

#include <cmath>

#include "engine/texture/noise.hpp"

namespace lute {

namespace {

// Where the point lies in its cube, scaled by the cubic of its distance from the centre.
dvec3 padding(const Quilted& pattern, const dvec3& p) {
  const dvec3 c{p.x - quirk_floor(p.x) - 0.5, p.y - quirk_floor(p.y) - 0.5, p.z - quirk_floor(p.z) - 0.5};
  const double t = glm::length(c), s = 1 - t;
  const double k = 1.154700538 * (t * t * t + 3 * t * s * s * pattern.control0 + 3 * t * t * s * pattern.control1);
  return c * k;
}

}  // namespace

double evaluate(const Quilted& pattern, const dvec3& p, const PatternContext&) {
  const dvec3 pad = padding(pattern, p);
  return (std::fabs(pad.x) + std::fabs(pad.y) + std::fabs(pad.z)) / 3;
}

dvec3 perturb(const Quilted& pattern, const dvec3& normal, double amount, const dvec3& p, const PatternContext&) {
  return normal + amount * padding(pattern, p);
}

}  // namespace lute
