#include "engine/shape/cylinder.hpp"

#include "engine/shape/axis_frame.hpp"
#include "engine/shape/empty_shape.hpp"
#include "engine/shape/truncated_cone.hpp"

namespace lute {

std::unique_ptr<Shape> build(const Cylinder& cylinder, const Transform& to_world, BuildContext&) {
  if (cylinder.radius == 0 || cylinder.base == cylinder.cap) return build_empty_shape(false);
  const Transform frame = axis_frame(cylinder.base, cylinder.cap - cylinder.base, cylinder.radius);
  return build_truncated_cone(to_world.identity() ? frame : frame.then(to_world), 0, cylinder.open);
}

}  // namespace lute
