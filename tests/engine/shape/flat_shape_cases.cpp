// Flat shapes and those made of faces: meshes, patches, height fields.
#include <algorithm>
#include <array>
#include <cmath>

#include "shape_case_parts.hpp"

namespace lute::test {
namespace {

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
Mesh ball_mesh(bool smooth, bool solid, bool textured = false) {
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
  if (textured) {
    data->textures.resize(3);
    for (std::uint32_t i = 0; i < data->faces.size(); ++i)
      data->texture_indices.push_back(i % 4 == 0 ? MeshData::Indices{i % 3, MeshData::kNone, MeshData::kNone} : MeshData::Indices{0, 1, 2});
  }
  return {data, solid ? dvec3(0.3, 0.2, 1) : dvec3(0), true};
}

ShapeCase mesh(std::string name, bool smooth, bool solid, bool textured = false) {
  const Mesh m = ball_mesh(smooth, solid, textured);
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

}  // namespace

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
  ShapeCase of_textures = mesh("mesh_textures", false, true, true);
  of_textures.textured = true;
  cases.push_back(of_textures);
  cases.push_back(bicubic("bicubic_patch", 3));
  cases.push_back(height_field("height_field", false, 0));
  cases.push_back(height_field("height_field_water", false, 0.4));
  cases.push_back(height_field("height_field_smooth", true, 0));
}

}  // namespace lute::test
