#include "engine/shape/unit_sphere_uv.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

double longitude_share(double x, double z) {
  const double squared = x * x + z * z;
  if (!(squared > kEpsilon)) return 0;
  if (z == 0) return x > 0 ? 0 : 0.5;
  const double angle = std::acos(std::clamp(x / std::sqrt(squared), -1.0, 1.0));
  return (z < 0 ? 2 * kPi - angle : angle) / (2 * kPi);
}

dvec2 unit_sphere_uv(const dvec3& q) {
  return {longitude_share(q.x, q.z), 0.5 + std::asin(std::clamp(q.y, -1.0, 1.0)) / kPi};
}

}  // namespace lute
