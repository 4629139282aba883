// One table of shapes for tests that hold for every shape: see random_rays_test.cpp. A new primitive gets a line
// in the file of its family.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/shape/shape.hpp"

namespace lute::test {

struct ShapeCase {
  std::string name;
  std::function<std::unique_ptr<Shape>(const Transform& to_world)> build;

  // About the radius of the shape as it is built with the identity; rays are aimed at points of a cube of this half side about `middle`.
  double size = 1;
  dvec3 middle{0};

  // How far a hit may lie from the surface, as a share of `size`. Greater than 1e-9 only where the language says so: the accuracy of
  // isosurfaces and parametrics, the last step of a fractal.
  double accuracy = 1e-9;
  // How far neighbouring hits scatter about a smooth surface, as a share of `size`.
  double scatter = 1e-12;

  // Distance of a local point from the surface, to first order. Without it, the inside test must differ on both sides of a hit.
  std::function<double(const dvec3&)> distance{};

  bool parity = true;          // hits lead in and out of what the inside test accepts
  bool textured = false;       // its parts have textures
  // Whether rounding decides if there is a hit at a local point, and all that follows on the ray: where a fractal fills the ball
  // that it is looked for in.
  std::function<bool(const dvec3&)> rounding_decides{};
  int rays = 400;              // fewer where each costs much
  bool own_normals = false;    // normals that are not those of the surface that is hit, as of smooth triangles
};

std::vector<ShapeCase> all_shape_cases();

}  // namespace lute::test
