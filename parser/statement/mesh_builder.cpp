#include "parser/statement/mesh_builder.hpp"

#include <cmath>
#include <string>

namespace lute {

dvec3 face_normal(const std::array<dvec3, 3>& vertices) {
  const dvec3 normal = glm::cross(vertices[2] - vertices[0], vertices[1] - vertices[0]);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : dvec3(0);
}

glm::vec3 vertex_normal(Reader& reader, dvec3 normal, const char* mesh, bool& warned) {
  if (std::abs(normal.x) < kEpsilon && std::abs(normal.y) < kEpsilon && std::abs(normal.z) < kEpsilon) {
    normal.x = 1;
    if (!warned) reader.warning(std::string("Normal vector in ") + mesh + " cannot be zero - changing it to <1,0,0>.");
    warned = true;
  }
  return single(normal / glm::length(normal));
}

bool normals_are_equal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto near = [&](const glm::vec3& other) {
    const dvec3 d = dvec3(a) - dvec3(other);
    return glm::dot(d, d) <= kEpsilon;
  };
  return near(b) && near(c);
}

std::uint32_t MeshTextures::index_of(const TexturePtr& texture) {
  const auto [found, added] = indices_.try_emplace(texture.get(), static_cast<std::uint32_t>(data_.textures.size()));
  if (added) data_.textures.push_back(texture);
  return found->second;
}

}  // namespace lute
