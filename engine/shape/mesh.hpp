// mesh { triangle {...} smooth_triangle {...} ... [inside_vector <v>] }
// mesh2 { vertex_vectors {...} [normal_vectors {...}] [uv_vectors {...}] [texture_list {...}] face_indices {...} ... }
//
// Both become one description: indexed triangles. Copies of a mesh in a scene share the data and its tree.
// Source: specification chapter 21 §3.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/shape/shape.hpp"

namespace lute {

struct Texture;  // engine/scene/texture.hpp

struct MeshData {
  using Indices = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  std::vector<glm::vec3> vertices;        // single precision, as the reference keeps them
  std::vector<Indices> faces;             // into vertices
  std::vector<glm::vec3> face_normals;    // one a face, unit, (p3-p1)x(p2-p1); zero for a degenerate face, which is never hit
  std::vector<glm::vec3> normals;         // unit; empty: all faces flat
  std::vector<Indices> normal_indices;    // empty, or one a face; {kNone,...}: a flat face
  std::vector<dvec2> uvs;                 // empty: (0, 0) everywhere
  std::vector<Indices> uv_indices;        // empty, or one a face
  std::vector<std::shared_ptr<const Texture>> textures;
  std::vector<Indices> texture_indices;   // empty, or one a face: {kNone,...} the mesh's own, {t, kNone, kNone} one texture, or three
};

struct Mesh {
  static constexpr std::string_view kKeyword = "mesh";
  std::shared_ptr<const MeshData> data;
  dvec3 inside_vector{0};  // world direction; zero: a patch without inside
  bool hierarchy = true;
};

std::unique_ptr<Shape> build(const Mesh& mesh, const SharedTransform& to_world, BuildContext& context);

}  // namespace lute
