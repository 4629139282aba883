#include "engine/shape/cone.hpp"

#include <algorithm>
#include <cmath>

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/cylinder.hpp"
#include "engine/shape/empty_shape.hpp"
#include "engine/shape/truncated_cone.hpp"

namespace lute {

std::unique_ptr<Shape> build(const Cone& cone, const Transform& to_world, BuildContext& context) {
  // Two negative radii pass for nearly equal ones in the reference, which are a cylinder.
  if (const double larger = std::max(cone.base_radius, cone.cap_radius); larger < 0)
    return build(Cylinder{cone.base, cone.cap, -larger, cone.open}, to_world, context);
  // The frame starts at the wider end, so that its unit is never zero unless the whole cone is.
  dvec3 wide = cone.base;
  dvec3 narrow = cone.cap;
  double wide_radius = cone.base_radius;
  double narrow_radius = cone.cap_radius;
  if (std::abs(narrow_radius) > std::abs(wide_radius)) {
    std::swap(wide, narrow);
    std::swap(wide_radius, narrow_radius);
  }
  if (wide_radius == 0 || wide == narrow) return build_empty_shape(false);
  const Transform frame = axis_frame(wide, narrow - wide, wide_radius).then(to_world);
  return build_truncated_cone(frame, frame.normal({0, 0, 1}), narrow_radius / wide_radius - 1, cone.open);
}

}  // namespace lute
