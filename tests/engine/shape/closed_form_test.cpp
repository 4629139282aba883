// Depths of hits against formulas in extended precision: spheres, boxes, cones and tori, and what other shapes make of them, at scales
// from 1e-6 to 1e6. The expected numbers come from the formulas below alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/shape/table.hpp"
#include "trace.hpp"

namespace lute::test {
namespace {

using Real = long double;
using Point = glm::vec<3, Real>;
using Depths = std::vector<Real>;  // ascending; only those in front of the origin

struct ExactRay {
  Point origin, direction;
  Point at(Real t) const { return origin + t * direction; }
};

Depths roots(Real a, Real half_b, Real c) {
  const Real discriminant = half_b * half_b - a * c;
  if (discriminant <= 0) return {};
  const Real q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));  // does not cancel
  Depths t{q / a, c / q};
  std::sort(t.begin(), t.end());
  return t;
}

Depths sphere(const ExactRay& r, Real radius) {
  return roots(glm::dot(r.direction, r.direction), glm::dot(r.origin, r.direction), glm::dot(r.origin, r.origin) - radius * radius);
}
Depths unit_sphere(const ExactRay& r) { return sphere(r, 1); }

// The box from -1 to 1.
Depths unit_box(const ExactRay& r) {
  Real near = -std::numeric_limits<Real>::infinity(), far = -near;
  for (int axis = 0; axis < 3; ++axis) {
    const Real a = (-1 - r.origin[axis]) / r.direction[axis], b = (1 - r.origin[axis]) / r.direction[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near < far ? Depths{near, far} : Depths{};
}

// About the y axis between -1 and 1, with radius 0.7 - 0.3 slope y; closed by discs.
Depths truncated_cone(const ExactRay& r, Real slope) {
  const Real k = -0.3L * slope, here = 0.7L + k * r.origin.y, grows = k * r.direction.y;
  Depths all;
  for (const Real t : roots(r.direction.x * r.direction.x + r.direction.z * r.direction.z - grows * grows,
                            r.origin.x * r.direction.x + r.origin.z * r.direction.z - here * grows,
                            r.origin.x * r.origin.x + r.origin.z * r.origin.z - here * here))
    if (std::abs(r.at(t).y) < 1) all.push_back(t);
  for (const Real y : {-1.0L, 1.0L}) {
    const Real t = (y - r.origin.y) / r.direction.y;
    if (std::hypot(r.at(t).x, r.at(t).z) < 0.7L + k * y) all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}
Depths cylinder(const ExactRay& r) { return truncated_cone(r, 0); }
Depths cone(const ExactRay& r) { return truncated_cone(r, 1); }

// The plane 2x - y + 3z = 0.5.
Depths plane(const ExactRay& r) {
  const Point n(2, -1, 3);
  return {(0.5L - glm::dot(n, r.origin)) / glm::dot(n, r.direction)};
}

struct ClosedForm {
  std::string name;
  std::function<std::unique_ptr<Shape>(const Transform&)> build;
  Depths (*depths)(const ExactRay&);
};
void PrintTo(const ClosedForm& c, std::ostream* out) { *out << c.name; }

template <class Description>
ClosedForm closed_form(std::string name, Description description, Depths (*depths)(const ExactRay&)) {
  return {std::move(name), [description](const Transform& to_world) { return make(description, to_world); }, depths};
}

Poly poly(int order, std::initializer_list<std::pair<std::array<int, 3>, double>> terms) {
  Poly p;
  p.order = order;
  p.coefficients.assign(Poly::term_count(order), 0);
  for (const auto& [power, value] : terms) p.coefficients[Poly::term_index(order, power[0], power[1], power[2])] = value;
  return p;
}

std::vector<ClosedForm> closed_forms() {
  // The density 4 (1 - ρ²/2)² of one ball of radius √2 is 1 where ρ = 1.
  Blob blob;
  blob.components.resize(1);
  blob.components[0].radius = std::sqrt(2.0);
  blob.components[0].strength = 4;
  SphereSweep capsule;  // a ball that hardly moves
  capsule.balls = {{dvec3(0), 1}, {dvec3(0, 1e-14, 0), 1}};
  const std::vector<dvec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  return {
      closed_form("sphere", Sphere{}, unit_sphere),
      closed_form("quadric_sphere", Quadric{dvec3(1), dvec3(0), dvec3(0), -1}, unit_sphere),
      closed_form("poly_sphere", poly(2, {{{2, 0, 0}, 1}, {{0, 2, 0}, 1}, {{0, 0, 2}, 1}, {{0, 0, 0}, -1}}), unit_sphere),
      closed_form("superellipsoid_sphere", Superellipsoid{1, 1}, unit_sphere),
      closed_form("blob_sphere", blob, unit_sphere),
      closed_form("sweep_sphere", capsule, unit_sphere),
      closed_form("box", Box{dvec3(-1), dvec3(1)}, unit_box),
      closed_form("prism_box", Prism{PlanarSpline::kLinear, false, -1, 1, square}, unit_box),
      closed_form("cylinder", Cylinder{{0, -1, 0}, {0, 1, 0}, 0.7}, cylinder),
      closed_form("lathe_cylinder", Lathe{PlanarSpline::kLinear, {{0, -1}, {0.7, -1}, {0.7, 1}, {0, 1}}}, cylinder),
      closed_form("cone", Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.4}, cone),
      closed_form("lathe_cone", Lathe{PlanarSpline::kLinear, {{0, -1}, {1, -1}, {0.4, 1}, {0, 1}}}, cone),
      closed_form("plane", Plane{{2, -1, 3}, 0.5 / std::sqrt(14.0)}, plane),
      closed_form("quadric_plane", Quadric{dvec3(0), dvec3(0), {2, -1, 3}, -0.5}, plane),
  };
}

class HasClosedForm : public testing::TestWithParam<ClosedForm> {};

// Both the place of the shape and the rays are taken as the doubles that they are, so that only the shape's arithmetic is measured. Rays that
// graze lose digits as they must: they are left out.
TEST_P(HasClosedForm, DepthsAreThoseOfTheFormula) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto anywhere = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    SCOPED_TRACE(testing::Message() << "scale " << scale);
    const dvec3 moved = 3 * scale * anywhere();
    const auto shape = GetParam().build(Transform::scale(dvec3(scale)).then(Transform::translate(moved)));
    int met = 0;
    for (int i = 0; i < 1000 && !HasFailure(); ++i) {
      const double far = std::pow(10, 1.5 + unit(random));
      const Ray ray = [&] {
        const dvec3 from = moved + scale * far * glm::normalize(anywhere());
        return Ray{from, glm::normalize(moved + 0.9 * scale * anywhere() - from)};
      }();
      const ExactRay local{(Point(ray.origin) - Point(moved)) / static_cast<Real>(scale), Point(ray.direction) / static_cast<Real>(scale)};
      Depths expected = GetParam().depths(local);
      std::erase_if(expected, [](Real t) { return t <= 0; });
      if (expected.size() == 2 && expected[1] - expected[0] < 0.2L * static_cast<Real>(scale)) continue;
      ShapeHits hits;
      shape->hits(ray, {0, std::numeric_limits<double>::infinity()}, hits);
      std::sort(hits.begin(), hits.end(), [](const ShapeHit& a, const ShapeHit& b) { return a.t < b.t; });
      const double farthest = std::min(1e3 * scale, 0.99e7);  // most shapes end at 1e7 units (chapter 20 §9)
      std::erase_if(hits, [&](const ShapeHit& h) { return h.t > farthest; });
      std::erase_if(expected, [&](Real t) { return t > farthest; });
      ASSERT_EQ(hits.size(), expected.size()) << "ray " << i << " far " << far;
      for (std::size_t k = 0; k < hits.size(); ++k)
        EXPECT_NEAR(static_cast<double>((static_cast<Real>(hits[k].t) - expected[k]) / expected[k]), 0, 1e-10) << "ray " << i << " hit " << k;
      met += hits.empty() ? 0 : 1;
    }
    EXPECT_GT(met, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, HasClosedForm, testing::ValuesIn(closed_forms()), [](const auto& test) { return test.param.name; });

// A torus has a closed form for rays along its axis at the distance a, y = ±√(r² - (a - R)²), and in its plane of symmetry x = ±R ± √(r² - y²).
TEST(Torus, DepthsAreThoseOfTheFormulaOnItsAxes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const double minor : {1e-3, 0.3, 0.9}) {
      SCOPED_TRACE(testing::Message() << "scale " << scale << " minor radius " << minor);
      const auto shape = make(Torus{scale, minor * scale});
      for (int i = 0; i < 100; ++i) {
        const double u = 0.95 * unit(random);
        const double far = scale * std::pow(10, 1 + unit(random)) + 2.5 * scale;
        const double a = scale * (1 + u * minor), y = scale * u * minor;
        const auto half_of = [&](double offset) {
          const Real r = static_cast<Real>(minor * scale), o = offset;
          return static_cast<double>(std::sqrt((r - o) * (r + o)));
        };
        const double tall = half_of(a - scale), wide = half_of(y);
        ShapeHits down, across;
        shape->hits({{a, far, 0}, {0, -1, 0}}, {0, 1e10 * scale}, down);
        shape->hits({{far, y, 0}, {-1, 0, 0}}, {0, 1e10 * scale}, across);
        const auto expect = [&](ShapeHits& hits, std::vector<double> expected) {
          std::sort(hits.begin(), hits.end(), [](const ShapeHit& p, const ShapeHit& q) { return p.t < q.t; });
          ASSERT_EQ(hits.size(), expected.size());
          for (std::size_t k = 0; k < hits.size(); ++k) EXPECT_NEAR(hits[k].t, expected[k], 1e-12 * far) << "hit " << k;
        };
        expect(down, {far - tall, far + tall});
        expect(across, {far - scale - wide, far - scale + wide, far + scale - wide, far + scale + wide});
      }
    }
}

}  // namespace
}  // namespace lute::test
