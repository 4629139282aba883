#include "shape_cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "engine/function/function.hpp"
#include "engine/shape/table.hpp"
#include "trace.hpp"

namespace lute::test {
namespace {

template <class Description>
std::function<std::unique_ptr<Shape>(const Transform&)> maker(Description description) {
  return [description](const Transform& to_world) { return make(description, to_world); };
}

// Distance from the zero of a function, to first order: its value over the length of its slope, found numerically.
template <class F>
std::function<double(const dvec3&)> to_first_order(F f, double step = 1e-6) {
  return [f, step](const dvec3& p) {
    const auto slope = [&](const dvec3& d) { return (f(p + step * d) - f(p - step * d)) / (2 * step); };
    return std::abs(f(p)) / glm::length(dvec3(slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})));
  };
}

class Formula final : public Function {
 public:
  Formula(int parameters, double (*f)(const double*)) : Function(parameters, 1), f_(f) {}
  void evaluate(const double* arguments, double* results) const override { *results = f_(arguments); }

 private:
  double (*f_)(const double*);
};
FunctionPtr formula(double (*f)(const double*)) { return std::make_shared<Formula>(3, f); }

// ---- solids with a formula ----

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
  cases.push_back(superellipsoid("superellipsoid_round", 0.8, 0.7));
  cases.push_back(superellipsoid("superellipsoid_box", 0.2, 0.25));
  cases.push_back(superellipsoid("superellipsoid_star", 2.4, 1.6));
  cases.push_back(blob("blob", true, 0));
  cases.push_back(blob("blob_many", true, 60));
  cases.push_back(blob("blob_many_without_hierarchy", false, 60));
}

// ---- swept shapes ----

ShapeCase ovus(std::string name, double bottom, double top) {
  return {std::move(name), maker(Ovus{bottom, top}), bottom + top, {0, bottom / 2, 0}};
}

// The sphere of a sweep's spline at a parameter: centre and radius.
dvec4 sweep_ball(const SphereSweep& s, double at) {
  const bool linear = s.spline == SphereSweep::Spline::kLinear;
  const std::size_t segments = s.balls.size() - (linear ? 1 : 3);
  const std::size_t i = std::min(static_cast<std::size_t>(at), segments - 1);
  const double u = at - static_cast<double>(i);
  const auto ball = [&](std::size_t k) { return dvec4(s.balls[i + k].center, s.balls[i + k].radius); };
  if (linear) return ball(0) + u * (ball(1) - ball(0));
  const dvec4 p0 = ball(0), p1 = ball(1), p2 = ball(2), p3 = ball(3);
  if (s.spline == SphereSweep::Spline::kBSpline)
    return (p0 + 4.0 * p1 + p2 + 3.0 * u * (p2 - p0) + 3.0 * u * u * (p0 - 2.0 * p1 + p2) + u * u * u * (p3 - p0 + 3.0 * (p1 - p2))) / 6.0;
  return p1 + 0.5 * (u * (p2 - p0) + u * u * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) + u * u * u * (p3 - p0 + 3.0 * (p1 - p2)));
}

// A hit lies on one of the spheres, but splines also show parts of spheres that others cover (specification chapter 20 §5.14).
ShapeCase sweep(std::string name, SphereSweep::Spline spline) {
  SphereSweep s;
  s.spline = spline;
  s.balls = {{{-1.2, -0.6, 0}, 0.2}, {{-0.6, 0.3, 0.1}, 0.3}, {{0, -0.3, -0.2}, 0.25}, {{0.6, 0.4, 0}, 0.2}, {{1.2, 0.3, 0.2}, 0.3}};
  ShapeCase c{std::move(name), maker(s), 1.2};
  if (spline == SphereSweep::Spline::kLinear) return c;
  c.parity = false;
  c.own_normals = true;
  c.distance = [s](const dvec3& p) {
    const auto outside = [&](double at) {
      const dvec4 ball = sweep_ball(s, at);
      return glm::length(p - dvec3(ball)) - ball.w;
    };
    constexpr int kSteps = 400;
    const double step = static_cast<double>(s.balls.size() - 3) / kSteps;
    double least = std::numeric_limits<double>::infinity();
    int nearest = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double here = outside(i * step);
      if (i > 0 && (here < 0) != (outside((i - 1) * step) < 0)) return 0.0;  // a sphere in between passes through the point
      if (std::abs(here) < least) {
        least = std::abs(here);
        nearest = i;
      }
    }
    // The point is on the envelope: the least distance lies next to the best step.
    double lo = std::max(0, nearest - 1) * step, hi = std::min(kSteps, nearest + 1) * step;
    for (int i = 0; i < 100; ++i) {
      const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
      (std::abs(outside(a)) < std::abs(outside(b)) ? hi : lo) = std::abs(outside(a)) < std::abs(outside(b)) ? b : a;
    }
    return std::abs(outside(0.5 * (lo + hi)));
  };
  return c;
}

void add_swept_shapes(std::vector<ShapeCase>& cases) {
  cases.push_back({"sor", maker(Sor{{{0, -1.2}, {0.5, -0.9}, {0.7, -0.4}, {0.25, 0.2}, {0.4, 0.7}, {0.45, 0.9}, {0.4, 1}}})});
  const std::vector<dvec2> closed_profile{{0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}};
  cases.push_back({"lathe_linear", maker(Lathe{PlanarSpline::kLinear, closed_profile})});
  cases.push_back({"lathe_quadratic", maker(Lathe{PlanarSpline::kQuadratic, {{0.3, -1.3}, {0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}}})});
  cases.push_back({"lathe_cubic", maker(Lathe{PlanarSpline::kCubic, {{0, -1.3}, {0, -1}, {0.7, -0.6}, {0.3, 0.1}, {0.6, 0.5}, {0, 0.9}, {0, 1.2}}})});
  cases.push_back({"lathe_bezier", maker(Lathe{PlanarSpline::kBezier, {{0, -1}, {0.9, -1}, {0.9, -0.2}, {0.3, 0}, {0.3, 0}, {0.1, 0.4}, {0.8, 0.6}, {0, 0.9}}, true})});
  const std::vector<dvec2> outline{{-0.6, -0.6}, {0.6, -0.6}, {0.8, 0.3}, {0, 0.9}, {-0.8, 0.3}, {-0.6, -0.6}, {-0.3, -0.3}, {0.2, -0.3}, {0.1, 0.3}, {-0.3, -0.3}};
  cases.push_back({"prism_linear", maker(Prism{PlanarSpline::kLinear, false, -0.5, 0.6, outline})});
  cases.push_back({"prism_conic", maker(Prism{PlanarSpline::kLinear, true, 0.2, 0.9, outline}), 1, {0, 0.5, 0}});
  cases.push_back({"prism_quadratic", maker(Prism{PlanarSpline::kQuadratic, false, -0.5, 0.6, {{-1, 0}, {0, -1}, {1.1, -0.2}, {0.5, 0.9}, {-0.8, 0.6}, {0, -1}}})});
  cases.push_back({"prism_cubic", maker(Prism{PlanarSpline::kCubic, false, -0.5, 0.6,
                                              {{-0.9, 0.9}, {-1, -0.8}, {0.2, -1.1}, {1.1, -0.6}, {0.8, 0.8}, {-0.9, 0.9}, {-1, -0.8}, {0.2, -1.1}}})});
  cases.push_back({"prism_bezier", maker(Prism{PlanarSpline::kBezier, false, -0.5, 0.6,
                                               {{-1, 0}, {-1, -0.9}, {0.8, -1}, {0.9, 0.1}, {0.9, 0.1}, {0.7, 1}, {-1, 1.1}, {-1, 0}}})});
  cases.push_back(ovus("ovus_slim", 0.7, 0.3));
  cases.push_back(ovus("ovus_stout", 0.5, 0.6));
  cases.push_back(sweep("sphere_sweep_linear", SphereSweep::Spline::kLinear));
  cases.push_back(sweep("sphere_sweep_cubic", SphereSweep::Spline::kCubic));
  cases.push_back(sweep("sphere_sweep_b_spline", SphereSweep::Spline::kBSpline));
  std::ifstream file("/usr/share/povray-3.7/include/timrom.ttf", std::ios::binary);
  std::ostringstream font;
  font << file.rdbuf();
  if (font.str().empty()) return;  // povray-includes is not installed
  cases.push_back({"text", maker(Text{std::make_shared<const std::string>(font.str()), u"Bg8", 0.5, dvec3(0)}), 0.8, {0.7, 0.3, 0.2}});
}

// ---- flat shapes and meshes ----

std::function<double(const dvec3&)> from_plane(const dvec3& point, const dvec3& normal) {
  return [=, n = glm::normalize(normal)](const dvec3& p) { return std::abs(glm::dot(p - point, n)); };
}

double from_face(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  // The hit may lie on the rim: how far beyond each edge, and how far from the plane.
  double beyond = std::abs(glm::dot(p - a, n));
  const dvec3 corners[4] = {a, b, c, a};
  for (int i = 0; i < 3; ++i) {
    const dvec3 outward = glm::normalize(glm::cross(corners[i + 1] - corners[i], n));
    beyond = std::max(beyond, glm::dot(p - corners[i], outward));
  }
  return beyond;
}

// A wavy closed surface of 2 * 16 * 32 triangles.
Mesh ball_mesh(bool smooth, bool solid) {
  constexpr std::uint32_t kRings = 16, kSides = 32;
  auto data = std::make_shared<MeshData>();
  const auto vertex = [&](std::uint32_t ring, std::uint32_t side) { return ring * kSides + side % kSides; };
  for (std::uint32_t ring = 0; ring <= kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double theta = kPi * ring / kRings, phi = 2 * kPi * side / kSides;
      const double r = 0.8 + 0.1 * std::sin(3 * phi) * std::sin(theta);
      const dvec3 p(r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi));
      data->vertices.emplace_back(p);
      if (smooth) data->normals.emplace_back(glm::normalize(p));
    }
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::vec3 p = data->vertices[a];
    const glm::vec3 n = glm::cross(data->vertices[c] - p, data->vertices[b] - p);
    data->faces.push_back({a, b, c});
    data->face_normals.push_back(glm::length(n) > 1e-9f ? glm::normalize(n) : glm::vec3(0));
  };
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      if (ring > 0) face(vertex(ring, side), vertex(ring, side + 1), vertex(ring + 1, side));
      if (ring + 1 < kRings) face(vertex(ring, side + 1), vertex(ring + 1, side + 1), vertex(ring + 1, side));
    }
  // The poles are one point each.
  for (std::uint32_t side = 1; side < kSides; ++side) {
    data->vertices[side] = data->vertices[0];
    data->vertices[vertex(kRings, side)] = data->vertices[vertex(kRings, 0)];
  }
  if (smooth) data->normal_indices = data->faces;
  return {data, solid ? dvec3(0.3, 0.2, 1) : dvec3(0), true};
}

ShapeCase mesh(std::string name, bool smooth, bool solid) {
  const Mesh m = ball_mesh(smooth, solid);
  ShapeCase c{std::move(name), maker(m)};
  c.parity = solid;
  c.own_normals = smooth;
  c.distance = [m](const dvec3& p) {
    double least = 1;
    for (const MeshData::Indices& f : m.data->faces)
      least = std::min(least, from_face(p, dvec3(m.data->vertices[f[0]]), dvec3(m.data->vertices[f[1]]), dvec3(m.data->vertices[f[2]])));
    return least;
  };
  return c;
}

ShapeCase bicubic(std::string name, int steps) {
  BicubicPatch patch;
  patch.u_steps = patch.v_steps = steps;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      patch.points[i][j] = {-0.9 + 0.6 * static_cast<double>(j), 0.4 * std::sin(static_cast<double>(3 * i + 5 * j)), -0.9 + 0.6 * static_cast<double>(i)};
  ShapeCase c{std::move(name), maker(patch)};
  c.parity = false;
  c.own_normals = true;  // those of the curved surface
  const int cells = 1 << steps;
  c.distance = [patch, cells](const dvec3& p) {
    const auto basis = [](double t) { return std::array<double, 4>{(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t), t * t * t}; };
    const auto at = [&](int iu, int iv) {
      const auto bu = basis(static_cast<double>(iu) / cells), bv = basis(static_cast<double>(iv) / cells);
      dvec3 sum(0);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum += bu[i] * bv[j] * patch.points[i][j];
      return sum;
    };
    double least = 1;
    for (int u = 0; u < cells; ++u)
      for (int v = 0; v < cells; ++v) {
        least = std::min(least, from_face(p, at(u, v), at(u, v + 1), at(u + 1, v + 1)));
        least = std::min(least, from_face(p, at(u, v), at(u + 1, v + 1), at(u + 1, v)));
      }
    return least;
  };
  return c;
}

void add_flat_shapes(std::vector<ShapeCase>& cases) {
  ShapeCase plane{"plane", maker(Plane{{1, 2, 3}, 0.1})};
  plane.distance = from_plane(0.1 * glm::normalize(dvec3(1, 2, 3)), {1, 2, 3});
  cases.push_back(plane);
  ShapeCase disc{"disc", maker(Disc{{0.1, 0, 0}, {1, 2, 3}, 0.8, 0.3})};
  disc.distance = from_plane({0.1, 0, 0}, {1, 2, 3});
  disc.parity = false;  // its inside is the half space behind it
  cases.push_back(disc);
  const std::array<dvec3, 3> corners{dvec3(-0.8, -0.7, 0.2), dvec3(0.9, -0.5, -0.3), dvec3(0, 0.9, 0.1)};
  ShapeCase triangle{"triangle", maker(Triangle{corners})};
  triangle.distance = [corners](const dvec3& p) { return from_face(p, corners[0], corners[1], corners[2]); };
  triangle.parity = false;
  cases.push_back(triangle);
  const dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  ShapeCase smooth = triangle;
  smooth.name = "smooth_triangle";
  smooth.build = maker(SmoothTriangle{corners, {n + dvec3(0.2, 0, 0), n - dvec3(0.3, 0.1, 0), n + dvec3(0, 0.4, 0.2)}});
  smooth.own_normals = true;
  cases.push_back(smooth);
  ShapeCase polygon{"polygon", maker(Polygon{{{-0.8, -0.8, 0}, {0.8, -0.8, 0}, {0.8, 0.8, 0}, {-0.8, 0.8, 0}, {-0.8, -0.8, 0},
                                              {-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0, 0.4, 0}, {-0.3, -0.3, 0}}})};
  polygon.distance = from_plane({0, 0, 0}, {0, 0, 1});
  polygon.parity = false;
  cases.push_back(polygon);
  cases.push_back(mesh("mesh", false, false));
  cases.push_back(mesh("mesh_smooth", true, false));
  cases.push_back(mesh("mesh_inside_vector", false, true));
  cases.push_back(bicubic("bicubic_patch", 3));
}

// ---- shapes of functions and heights ----

ShapeCase height_field(std::string name, bool smooth, double water_level) {
  auto grid = std::make_shared<HeightGrid>();
  grid->width = 23;
  grid->depth = 17;
  for (int z = 0; z < grid->depth; ++z)
    for (int x = 0; x < grid->width; ++x)
      grid->heights.push_back(static_cast<std::uint16_t>(32768 + 26000 * std::sin(0.6 * x) * std::cos(0.8 * z)));
  ShapeCase c{std::move(name), maker(HeightField{grid, water_level, smooth}), 0.7, {0.5, 0.5, 0.5}};
  c.own_normals = smooth;
  c.parity = false;  // open below and at the sides
  c.distance = [grid](const dvec3& p) {
    double least = 1;
    const auto at = [&](int x, int z) {
      return dvec3(static_cast<double>(x) / (grid->width - 1), grid->at(x, z) / 65536.0, static_cast<double>(z) / (grid->depth - 1));
    };
    for (int z = 0; z + 1 < grid->depth; ++z)
      for (int x = 0; x + 1 < grid->width; ++x) {
        least = std::min(least, from_face(p, at(x, z), at(x + 1, z), at(x, z + 1)));
        least = std::min(least, from_face(p, at(x + 1, z + 1), at(x, z + 1), at(x + 1, z)));
      }
    return least;
  };
  // Triangles reach 1e-4 of a cell beyond their edges (specification chapter 21 §6.4).
  c.accuracy = 1e-5;
  return c;
}

ShapeCase julia(std::string name, JuliaFractal::Algebra algebra, JuliaFractal::Function function) {
  JuliaFractal f;
  f.constant = {-0.083, 0, -0.6, -0.025};
  f.algebra = algebra;
  f.function = function;
  f.max_iteration = 4;
  f.precision = 200;
  ShapeCase c{std::move(name), maker(f)};
  c.accuracy = 1e-6;
  c.scatter = 2e-7;
  c.own_normals = true;  // those of the last iterate; the surface is where the one before it leaves the ball
  return c;
}

double wavy_ball(const double* p) {
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 0.5 + 0.1 * std::sin(5 * p[0]) * std::sin(4 * p[1]);
}

ShapeCase isosurface(std::string name, bool round) {
  Isosurface iso;
  iso.function = formula(wavy_ball);
  iso.max_gradient = 3;
  iso.accuracy = 1e-6;
  iso.max_trace = 10;
  iso.container.is_sphere = round;
  ShapeCase c{std::move(name), maker(iso)};
  c.distance = to_first_order([](const dvec3& p) { return wavy_ball(&p.x); });
  c.accuracy = c.scatter = 1e-5;
  return c;
}

void add_function_shapes(std::vector<ShapeCase>& cases) {
  cases.push_back(height_field("height_field", false, 0));
  cases.push_back(height_field("height_field_water", false, 0.4));
  cases.push_back(height_field("height_field_smooth", true, 0));
  cases.push_back(julia("julia_quaternion_sqr", JuliaFractal::Algebra::kQuaternion, JuliaFractal::Function::kSqr));
  cases.push_back(julia("julia_quaternion_cube", JuliaFractal::Algebra::kQuaternion, JuliaFractal::Function::kCube));
  cases.push_back(julia("julia_hypercomplex_sqr", JuliaFractal::Algebra::kHypercomplex, JuliaFractal::Function::kSqr));
  cases.push_back(isosurface("isosurface", false));
  cases.push_back(isosurface("isosurface_in_sphere", true));
  Parametric saddle;
  saddle.functions = {formula([](const double* p) { return p[0]; }), formula([](const double* p) { return 0.6 * p[0] * p[1]; }),
                      formula([](const double* p) { return p[1]; })};
  saddle.lo = {-0.9, -0.9};
  saddle.hi = {0.9, 0.9};
  saddle.accuracy = 1e-4;
  saddle.max_gradient = 1.2;
  ShapeCase parametric{"parametric", maker(saddle)};
  parametric.distance = to_first_order([](const dvec3& p) { return p.y - 0.6 * p.x * p.z; });
  parametric.parity = false;
  // The size of the last rectangle; along a ray that grazes, its box is longer.
  parametric.accuracy = 0.02;
  parametric.scatter = 1e-3;
  cases.push_back(parametric);
}

}  // namespace

std::vector<ShapeCase> all_shape_cases() {
  std::vector<ShapeCase> cases;
  add_formula_solids(cases);
  add_swept_shapes(cases);
  add_flat_shapes(cases);
  add_function_shapes(cases);
  return cases;
}

}  // namespace lute::test
