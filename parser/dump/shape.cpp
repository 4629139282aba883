// Shapes: their keyword and what was written.
#include "parser/dump/values.hpp"

namespace lute::dump {
namespace {

template <class T>
Json array_of(const T& values) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(to_json(value));
  return array;
}

Json points(const std::vector<dvec2>& values) { return array_of(values); }

Json fields(const Box& s) { return {{"corner_a", to_json(s.corner_a)}, {"corner_b", to_json(s.corner_b)}}; }
Json fields(const Sphere& s) { return {{"center", to_json(s.center)}, {"radius", s.radius}}; }
Json fields(const Plane& s) { return {{"normal", to_json(s.normal)}, {"distance", s.distance}}; }
Json fields(const Cone& s) {
  return {{"base", to_json(s.base)}, {"base_radius", s.base_radius}, {"cap", to_json(s.cap)}, {"cap_radius", s.cap_radius}, {"open", s.open}};
}
Json fields(const Cylinder& s) {
  return {{"base", to_json(s.base)}, {"cap", to_json(s.cap)}, {"radius", s.radius}, {"open", s.open}};
}
Json fields(const Disc& s) {
  return {{"center", to_json(s.center)}, {"normal", to_json(s.normal)}, {"radius", s.radius}, {"hole_radius", s.hole_radius}};
}
Json fields(const Torus& s) { return {{"major_radius", s.major_radius}, {"minor_radius", s.minor_radius}, {"sturm", s.sturm}}; }
Json fields(const Ovus& s) { return {{"bottom_radius", s.bottom_radius}, {"top_radius", s.top_radius}, {"sturm", s.sturm}}; }
Json fields(const Superellipsoid& s) { return {{"east_west", s.east_west}, {"north_south", s.north_south}}; }
Json fields(const Triangle& s) { return {{"vertices", array_of(s.vertices)}}; }
Json fields(const SmoothTriangle& s) { return {{"vertices", array_of(s.vertices)}, {"normals", array_of(s.normals)}}; }
Json fields(const Polygon& s) { return {{"points", array_of(s.points)}}; }
Json fields(const Quadric& s) {
  return {{"squares", to_json(s.squares)}, {"mixed", to_json(s.mixed)}, {"linear", to_json(s.linear)}, {"constant", s.constant}};
}
Json fields(const Poly& s) { return {{"order", s.order}, {"coefficients", array_of(s.coefficients)}, {"sturm", s.sturm}}; }

std::string name_of(PlanarSpline spline) {
  switch (spline) {
    case PlanarSpline::kLinear: return "linear";
    case PlanarSpline::kQuadratic: return "quadratic";
    case PlanarSpline::kCubic: return "cubic";
    case PlanarSpline::kBezier: return "bezier";
  }
  return {};
}

Json fields(const Lathe& s) { return {{"spline", name_of(s.spline)}, {"points", points(s.points)}, {"sturm", s.sturm}}; }
Json fields(const Sor& s) { return {{"points", points(s.points)}, {"open", s.open}, {"sturm", s.sturm}}; }
Json fields(const Prism& s) {
  return {{"spline", name_of(s.spline)}, {"conic", s.conic}, {"heights", {s.height_1, s.height_2}}, {"points", points(s.points)},
          {"open", s.open}, {"sturm", s.sturm}};
}
Json fields(const SphereSweep& s) {
  Json balls = Json::array();
  for (const auto& ball : s.balls) balls.push_back({{"center", to_json(ball.center)}, {"radius", ball.radius}});
  return {{"spline", static_cast<int>(s.spline)}, {"balls", balls}, {"tolerance", s.tolerance}};
}

Json fields(const BicubicPatch& s) {
  Json rows = Json::array();
  for (const auto& row : s.points) rows.push_back(array_of(row));
  return {{"flatness", s.flatness}, {"u_steps", s.u_steps}, {"v_steps", s.v_steps}, {"uv", array_of(s.corner_uv)}, {"points", rows}};
}

Json fields(const Blob& s) {
  Json components = Json::array();
  for (const BlobComponent& c : s.components) {
    Json component{{"kind", c.kind == BlobComponent::Kind::kSphere ? "sphere" : "cylinder"}, {"center", to_json(c.center)},
                   {"radius", c.radius}, {"strength", c.strength}, {"transform", to_json(c.transform)},
                   {"texture", to_json(c.texture)}, {"texture_placement", to_json(c.texture_placement)}};
    if (c.kind == BlobComponent::Kind::kCylinder) component["apex"] = to_json(c.apex);
    components.push_back(std::move(component));
  }
  return {{"threshold", s.threshold}, {"components", components}, {"sturm", s.sturm}, {"hierarchy", s.hierarchy}};
}

Json vectors(const std::vector<glm::vec3>& values) {
  Json array = Json::array();
  for (const glm::vec3& v : values) array.push_back({single(v.x), single(v.y), single(v.z)});
  return array;
}

Json indices(const std::vector<MeshData::Indices>& values) {
  Json array = Json::array();
  for (const MeshData::Indices& triple : values) {
    Json entry = Json::array();
    for (const std::uint32_t i : triple) entry.push_back(i == MeshData::kNone ? Json() : Json(i));
    array.push_back(std::move(entry));
  }
  return array;
}

Json fields(const Mesh& s) {
  const MeshData& d = *s.data;
  return {{"vertices", vectors(d.vertices)}, {"faces", indices(d.faces)}, {"face_normals", vectors(d.face_normals)},
          {"normals", vectors(d.normals)}, {"normal_indices", indices(d.normal_indices)}, {"uvs", points(d.uvs)},
          {"uv_indices", indices(d.uv_indices)}, {"textures", array_of(d.textures)}, {"texture_indices", indices(d.texture_indices)},
          {"inside_vector", to_json(s.inside_vector)}, {"hierarchy", s.hierarchy}};
}

Json fields(const HeightField& s) {
  Json heights = Json::array();
  for (const std::uint16_t h : s.grid->heights) heights.push_back(h);
  return {{"width", s.grid->width}, {"depth", s.grid->depth}, {"heights", heights}, {"water_level", s.water_level}, {"smooth", s.smooth}};
}

Json fields(const JuliaFractal& s) {
  return {{"constant", to_json(s.constant)}, {"hypercomplex", s.algebra == JuliaFractal::Algebra::kHypercomplex},
          {"function", static_cast<int>(s.function)}, {"exponent", to_json(s.exponent)}, {"max_iteration", s.max_iteration},
          {"precision", s.precision}, {"slice", to_json(s.slice)}, {"slice_distance", s.slice_distance}};
}

Json container(const Container& c) {
  if (c.is_sphere) return {{"center", to_json(c.center)}, {"radius", c.radius}};
  return {{"lo", to_json(c.lo)}, {"hi", to_json(c.hi)}};
}

Json fields(const Isosurface& s) {
  return {{"contained_by", container(s.container)}, {"threshold", s.threshold}, {"accuracy", s.accuracy},
          {"max_gradient", s.max_gradient}, {"max_trace", s.max_trace}, {"evaluate", s.evaluate ? array_of(*s.evaluate) : Json()},
          {"open", s.open}};
}
Json fields(const Parametric& s) {
  return {{"lo", to_json(s.lo)}, {"hi", to_json(s.hi)}, {"contained_by", container(s.container)}, {"accuracy", s.accuracy},
          {"max_gradient", s.max_gradient}};
}

Json fields(const Text& s) {
  Json codes = Json::array();
  for (const char16_t c : s.string) codes.push_back(static_cast<int>(c));
  return {{"codes", codes}, {"depth", s.depth}, {"offset", to_json(s.offset)}, {"unicode_first", s.unicode_first}};
}

}  // namespace

Json to_json(const AnyShape& shape) {
  return shape.visit(
      [](const auto& s) {
        Json json = fields(s);
        json["shape"] = s.kKeyword;
        return json;
      });
}

}  // namespace lute::dump
