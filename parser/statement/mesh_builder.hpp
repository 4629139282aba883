// What mesh and mesh2 have in common: single-precision vertices, normals, the rule that makes a face flat.
// Source: specification chapter 21 §3.
#pragma once

#include <array>
#include <map>

#include "parser/reader.hpp"

namespace lute {

inline glm::vec3 single(const dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// (p3 - p1) x (p2 - p1) of unit length, computed in double precision; zero for a degenerate face.
dvec3 face_normal(const std::array<dvec3, 3>& vertices);

// A unit normal; a zero one becomes <1, 0, 0> with one warning a mesh.
glm::vec3 vertex_normal(Reader& reader, dvec3 normal, const char* mesh, bool& warned);

// Nearly equal normals: the face's own normal is used.
bool normals_are_equal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

// Gives each texture of a mesh one number.
class MeshTextures {
 public:
  explicit MeshTextures(MeshData& data) : data_(data) {}
  std::uint32_t index_of(const TexturePtr& texture);

 private:
  MeshData& data_;
  std::map<const Texture*, std::uint32_t> indices_;
};

}  // namespace lute
