#include "engine/shape/cylinder.hpp"

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/empty_shape.hpp"
#include "engine/shape/truncated_cone.hpp"

namespace lute {

std::unique_ptr<Shape> build(const Cylinder& cylinder, const Transform& to_world, BuildContext&) {
  if (cylinder.radius == 0 || cylinder.base == cylinder.cap) return build_empty_shape(false);
  // From the cap to the base, as POV-Ray has it.
  const dvec3 axis = cylinder.base - cylinder.cap;
  const double length = glm::length(axis);
  const dvec3 axis_normal = turn_z_to(axis / length)[2] / length;
  return build_truncated_cone(axis_frame(cylinder.cap, axis, cylinder.radius).then(to_world),
                              to_world.identity() ? axis_normal : to_world.normal(axis_normal), 0, cylinder.open);
}

}  // namespace lute
