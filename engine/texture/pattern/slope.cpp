#include "engine/texture/pattern/slope.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/rounding.hpp"
#include "engine/texture/surface_context.hpp"

namespace lute {
namespace {

double rescaled(double v, double low, double high) { return high - low != 0 ? (v - low) / (high - low) : v; }

double wrapped(double v) { return v < 0 ? 1 + fraction(v) : fraction(v); }

}  // namespace

double evaluate(const Slope& pattern, const dvec3& p, const PatternContext& context) {
  const SurfaceContext& surface = *context.surface;
  if (!surface.has_surface) return 0;
  const dvec3 toward = pattern.point_at ? pattern.vector - surface.point : pattern.vector;
  const double slope_length = glm::length(toward), altitude_length = glm::length(pattern.altitude);

  double s = slope_length > 0 ? std::clamp(glm::dot(surface.normal, toward) / slope_length, -1.0, 1.0) : 0;
  s = (std::asin(s) * 2 / kPi + 1) / 2;
  s = rescaled(s, pattern.low, pattern.high);
  if (altitude_length == 0 || pattern.point_at) return s == 1 ? 1 - kEpsilon : wrapped(s);

  const double a = rescaled(glm::dot(p, pattern.altitude) / altitude_length, pattern.altitude_low, pattern.altitude_high);
  const double weight = slope_length / (slope_length + altitude_length);
  const double v = weight * s + (1 - weight) * a;
  return v >= 1 && v < 1 + kEpsilon ? v - kEpsilon : wrapped(v);
}

}  // namespace lute
