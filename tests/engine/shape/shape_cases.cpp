// Solids with a formula, and the table of all cases.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "shape_case_parts.hpp"

namespace lute::test {
namespace {

ShapeCase torus(std::string name, double major, double minor, bool sturm) {
  ShapeCase c{std::move(name), maker(Torus{major, minor, sturm}), major + minor};
  c.distance = [=](const dvec3& p) {
    const double rho = std::hypot(p.x, p.z);
    // A spindle has a second sheet, on the other side of the axis.
    return std::min(std::abs(std::hypot(rho - major, p.y) - minor), std::abs(std::hypot(rho + major, p.y) - minor));
  };
  // The lemon of a spindle is inside of both sheets, and the inner sheet has the normal formula of the outer one.
  c.parity = minor <= major;
  c.own_normals = minor > major;
  return c;
}

Poly polynomial(int order, const std::vector<std::pair<std::array<int, 3>, double>>& terms, bool sturm) {
  Poly poly;
  poly.order = order;
  poly.sturm = sturm;
  poly.coefficients.assign(Poly::term_count(order), 0);
  for (const auto& [power, value] : terms) poly.coefficients[Poly::term_index(order, power[0], power[1], power[2])] = value;
  return poly;
}

ShapeCase polynomial_case(std::string name, int order, const std::vector<std::pair<std::array<int, 3>, double>>& terms, bool sturm) {
  ShapeCase c{std::move(name), maker(polynomial(order, terms, sturm))};
  c.distance = to_first_order([terms](const dvec3& p) {
    double sum = 0;
    for (const auto& [power, value] : terms) sum += value * std::pow(p.x, power[0]) * std::pow(p.y, power[1]) * std::pow(p.z, power[2]);
    return sum;
  });
  return c;
}

ShapeCase superellipsoid(std::string name, double e, double n) {
  ShapeCase c{std::move(name), maker(Superellipsoid{e, n}), 1.2};
  c.distance = to_first_order([=](const dvec3& p) {
    const double round = std::pow(std::pow(std::abs(p.x), 2 / e) + std::pow(std::abs(p.y), 2 / e), e / n);
    return round + std::pow(std::abs(p.z), 2 / n) - 1;
  });
  return c;
}

BlobComponent component(const dvec3& center, double radius, double strength) {
  BlobComponent c;
  c.center = center;
  c.radius = radius;
  c.strength = strength;
  return c;
}

ShapeCase blob(std::string name, bool hierarchy, int more) {
  Blob blob;
  blob.threshold = 0.5;
  blob.hierarchy = hierarchy;
  blob.components = {component({-0.4, 0, 0}, 0.9, 1), component({0.5, 0.2, 0}, 0.8, 1.2), component({0, 0.4, -0.3}, 0.5, -0.7)};
  BlobComponent rod = component({-0.3, -0.6, 0}, 0.5, 1);
  rod.kind = BlobComponent::Kind::kCylinder;
  rod.apex = {0.6, -0.5, 0.2};
  blob.components.push_back(rod);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < more; ++i) blob.components.push_back(component({unit(random), unit(random), unit(random)}, 0.3, 0.8));
  ShapeCase c{std::move(name), maker(blob)};
  c.distance = to_first_order([blob](const dvec3& p) {
    double sum = -blob.threshold;
    for (const BlobComponent& b : blob.components) {
      dvec3 nearest = b.center;
      if (b.kind == BlobComponent::Kind::kCylinder) {
        const dvec3 axis = b.apex - b.center;
        nearest += std::clamp(glm::dot(p - b.center, axis) / glm::dot(axis, axis), 0.0, 1.0) * axis;
      }
      const double closeness = 1 - glm::dot(p - nearest, p - nearest) / (b.radius * b.radius);
      if (closeness > 0) sum += b.strength * closeness * closeness;
    }
    return sum;
  });
  return c;
}

}  // namespace

void add_formula_solids(std::vector<ShapeCase>& cases) {
  cases.push_back({"sphere", maker(Sphere{{0.1, -0.2, 0.3}, 0.8})});
  cases.push_back({"box", maker(Box{dvec3(-0.7, -0.8, -0.5), dvec3(0.6, 0.9, 0.7)})});
  cases.push_back({"cylinder", maker(Cylinder{{-0.5, -0.6, 0.1}, {0.4, 0.7, -0.2}, 0.4})});
  cases.push_back({"cone", maker(Cone{{-0.5, -0.6, 0.1}, {0.4, 0.7, -0.2}, 0.6, 0.2})});
  cases.push_back({"cone_apex", maker(Cone{{0, -0.8, 0}, {0, 0.8, 0}, 0.7, 0})});
  cases.push_back({"cone_double", maker(Cone{{0, -0.8, 0}, {0.2, 0.8, 0}, 0.7, -0.4})});
  ShapeCase open_tube{"cylinder_open", maker(Cylinder{{0, -0.6, 0}, {0, 0.7, 0}, 0.4, true})};
  open_tube.distance = [](const dvec3& p) { return std::abs(std::hypot(p.x, p.z) - 0.4); };
  open_tube.parity = false;
  cases.push_back(open_tube);
  ShapeCase open_cone{"cone_open", maker(Cone{{0, -0.7, 0}, {0, 0.8, 0}, 0.6, 0.2, true})};
  open_cone.distance = [](const dvec3& p) {
    const double slope = 0.4 / 1.5, radius = 0.6 - slope * (p.y + 0.7);
    return std::abs(std::hypot(p.x, p.z) - radius) / std::sqrt(1 + slope * slope);
  };
  open_cone.parity = false;
  cases.push_back(open_cone);
  cases.push_back(torus("torus", 0.7, 0.25, false));
  cases.push_back(torus("torus_thin", 0.9, 0.02, true));
  cases.push_back(torus("torus_spindle", 0.3, 0.6, false));
  cases.push_back({"quadric_ellipsoid", maker(Quadric{{2, 3, 4}, {0.3, 0.2, 0.1}, {0.1, 0, 0.2}, -1})});
  ShapeCase hyperboloid{"quadric_hyperboloid", maker(Quadric{{2, -3, 4}, {0.3, 0.2, 0.1}, {0.1, 0, 0.2}, -0.5})};
  cases.push_back(hyperboloid);
  cases.push_back(polynomial_case("cubic", 3, {{{3, 0, 0}, 1}, {{0, 3, 0}, 1}, {{0, 0, 3}, 1}, {{1, 1, 0}, -0.6}, {{0, 0, 0}, -0.1}}, false));
  for (const bool sturm : {false, true}) {
    const std::string tail = sturm ? "_sturm" : "";
    cases.push_back(polynomial_case("quartic" + tail, 4,
                                    {{{4, 0, 0}, 1}, {{0, 4, 0}, 2}, {{0, 0, 4}, 1}, {{2, 2, 0}, -1.5}, {{1, 0, 1}, 0.3}, {{0, 0, 0}, -0.3}}, sturm));
    cases.push_back(polynomial_case("poly_order_7" + tail, 7,
                                    {{{6, 0, 0}, 3}, {{0, 6, 0}, 4}, {{0, 0, 6}, 3}, {{2, 3, 2}, -1}, {{1, 0, 1}, 0.3}, {{0, 0, 0}, -0.3}}, sturm));
    cases.push_back(polynomial_case("poly_order_16" + tail, 16, {{{16, 0, 0}, 1}, {{0, 16, 0}, 1}, {{0, 0, 16}, 1}, {{0, 0, 0}, -0.01}}, sturm));
  }
  cases.push_back(polynomial_case("poly_order_35", 35,
                                  {{{34, 0, 0}, 1}, {{0, 34, 0}, 1}, {{0, 0, 34}, 1}, {{12, 10, 12}, 0.4}, {{0, 0, 0}, -1e-3}}, false));
  cases.back().rays = 100;
  cases.push_back(superellipsoid("superellipsoid_round", 0.8, 0.7));
  cases.push_back(superellipsoid("superellipsoid_box", 0.2, 0.25));
  cases.push_back(superellipsoid("superellipsoid_star", 2.4, 1.6));
  cases.push_back(blob("blob", true, 0));
  cases.push_back(blob("blob_many", true, 60));
  cases.push_back(blob("blob_many_without_hierarchy", false, 60));
}

std::vector<ShapeCase> all_shape_cases() {
  std::vector<ShapeCase> cases;
  add_formula_solids(cases);
  add_swept_shapes(cases);
  add_flat_shapes(cases);
  add_function_shapes(cases);
  return cases;
}

}  // namespace lute::test
