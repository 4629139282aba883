#include "engine/light/area.hpp"

#include <algorithm>
#include <cmath>

namespace lute {

AreaAxes area_axes(const BuiltLight& light, const dvec3& to_center) {
  if (!light.area->orient) return {light.area->axis1, light.area->axis2};
  const dvec3 side = std::abs(std::abs(to_center.z) - 1) < 0.01 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 first = glm::normalize(glm::cross(to_center, side)) * light.axis1_length;
  const dvec3 second = glm::normalize(glm::cross(to_center, first)) * light.axis1_length;
  return {first, second};
}

dvec3 area_offset(const AreaLight& area, const AreaAxes& axes, double u, double v) {
  if (area.circular) {
    // The square grid is pulled onto a disc; the small shift keeps its centre from dividing zero by zero.
    constexpr double kOffCentre = 0.001;
    const double x = u / (area.size1 - 1) - 0.5 + kOffCentre;
    const double y = v / (area.size2 - 1) - 0.5 + kOffCentre;
    const double k = std::max(std::abs(x), std::abs(y)) / std::sqrt(x * x + y * y);
    return axes.axis1 * (k * x) + axes.axis2 * (k * y);
  }
  dvec3 offset{0};
  if (area.size1 > 1) offset += axes.axis1 * (u / (area.size1 - 1) - 0.5);
  if (area.size2 > 1) offset += axes.axis2 * (v / (area.size2 - 1) - 0.5);
  return offset;
}

}  // namespace lute
