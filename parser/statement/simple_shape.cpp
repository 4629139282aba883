// box, cone, cylinder, disc, plane, sphere, torus, triangle, smooth_triangle.
#include <array>

#include "parser/statement/simple_shape.hpp"

namespace lute {
namespace {

dvec3 vector_and_comma(Reader& reader) {
  const dvec3 value = reader.vector();
  reader.comma();
  return value;
}

double number_and_comma(Reader& reader) {
  const double value = reader.number();
  reader.comma();
  return value;
}

bool is_degenerate(const std::array<dvec3, 3>& p) {
  return glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) < kEpsilon;
}

}  // namespace

Box parse_box(Reader& reader) {
  Box box;
  box.corner_a = vector_and_comma(reader);
  box.corner_b = reader.vector();
  return box;
}

Cone parse_cone(Reader& reader) {
  Cone cone;
  cone.base = vector_and_comma(reader);
  cone.base_radius = number_and_comma(reader);
  cone.cap = vector_and_comma(reader);
  cone.cap_radius = reader.number();
  cone.open = reader.accept(Word::kOpen);
  if (glm::length(cone.cap - cone.base) < kEpsilon) reader.error("Degenerate cone/cylinder.");
  return cone;
}

Cylinder parse_cylinder(Reader& reader) {
  Cylinder cylinder;
  cylinder.base = vector_and_comma(reader);
  cylinder.cap = vector_and_comma(reader);
  cylinder.radius = reader.number();
  cylinder.open = reader.accept(Word::kOpen);
  if (glm::length(cylinder.cap - cylinder.base) < kEpsilon) reader.error("Degenerate cylinder, base point = apex point.");
  return cylinder;
}

Disc parse_disc(Reader& reader) {
  Disc disc;
  disc.center = vector_and_comma(reader);
  disc.normal = vector_and_comma(reader);
  disc.radius = number_and_comma(reader);
  while (const auto hole = reader.optional_number()) disc.hole_radius = *hole;
  return disc;
}

Plane parse_plane(Reader& reader) {
  Plane plane;
  plane.normal = vector_and_comma(reader);
  plane.distance = reader.number();
  const double length = glm::length(plane.normal);
  if (length < kEpsilon) reader.error("Degenerate plane normal.");
  plane.normal /= length;
  return plane;
}

Sphere parse_sphere(Reader& reader) {
  Sphere sphere;
  sphere.center = vector_and_comma(reader);
  sphere.radius = reader.number();
  return sphere;
}

Torus parse_torus(Reader& reader) {
  Torus torus;
  torus.major_radius = number_and_comma(reader);
  torus.minor_radius = reader.number();
  return torus;
}

Triangle parse_triangle(Reader& reader) {
  Triangle triangle;
  for (dvec3& vertex : triangle.vertices) {
    if (&vertex != triangle.vertices.data()) reader.comma();
    vertex = reader.vector();
  }
  if (is_degenerate(triangle.vertices)) reader.warning("Degenerate triangle. Please remove.");
  return triangle;
}

SmoothTriangle parse_smooth_triangle(Reader& reader) {
  SmoothTriangle triangle;
  bool zero_normal = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) reader.comma();
    triangle.vertices[i] = reader.vector();
    reader.comma();
    triangle.normals[i] = reader.vector();
    zero_normal = zero_normal || glm::length(triangle.normals[i]) == 0;
  }
  if (zero_normal || is_degenerate(triangle.vertices)) reader.warning("Degenerate triangle. Please remove.");
  return triangle;
}

}  // namespace lute
