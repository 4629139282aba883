// mesh { triangle {...} smooth_triangle {...} ... inside_vector V } (specification chapter 21 §3.2).
#include <unordered_map>

#include "parser/statement/mesh_builder.hpp"
#include "parser/statement/simple_shape.hpp"

namespace lute {
namespace {

constexpr MeshData::Indices kNoIndices{MeshData::kNone, MeshData::kNone, MeshData::kNone};

struct MeshTriangle {
  std::array<dvec3, 3> vertices{}, normals{};
  std::optional<std::array<dvec2, 3>> uv;
  std::array<TexturePtr, 3> textures{};  // one, or three
  bool smooth = false;
};

TexturePtr texture_identifier(Reader& reader) {
  const auto texture = reader.accept_identifier<TexturePtr>();
  if (!texture) reader.error_expected("texture identifier");
  return *texture;
}

void parse_triangle_textures(Reader& reader, MeshTriangle& triangle) {
  if (reader.accept(Word::kTexture)) {
    reader.open(Word::kTexture);
    triangle.textures[0] = texture_identifier(reader);
    reader.close(Word::kTexture);
  } else if (reader.accept(Word::kTextureList)) {
    reader.open(Word::kTextureList);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) reader.comma();
      triangle.textures[i] = texture_identifier(reader);
    }
    reader.close(Word::kTextureList);
  }
}

MeshTriangle parse_mesh_triangle(Reader& reader, Word keyword) {
  MeshTriangle triangle;
  triangle.smooth = keyword == Word::kSmoothTriangle;
  reader.open(keyword);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) reader.comma();
    triangle.vertices[i] = reader.vector();
    if (!triangle.smooth) continue;
    reader.comma();
    triangle.normals[i] = reader.vector();
  }
  if (reader.accept(Word::kUvVectors)) {
    triangle.uv.emplace();
    for (dvec2& uv : *triangle.uv) {
      uv = reader.vector2();
      reader.comma();
    }
  }
  parse_triangle_textures(reader, triangle);
  reader.close(keyword);
  return triangle;
}

// Collects triangles: equal vertices are stored once.
class MeshCollector {
 public:
  explicit MeshCollector(Reader& reader) : reader_(reader) {}

  void add(const MeshTriangle& triangle) {
    const dvec3 normal = face_normal(triangle.vertices);
    if (normal == dvec3(0)) return;
    MeshData::Indices face{};
    for (std::size_t i = 0; i < 3; ++i) face[i] = vertex(single(triangle.vertices[i]));
    data_->faces.push_back(face);
    data_->face_normals.push_back(single(normal));
    add_normals(triangle);
    add_uv(triangle);
    add_textures(triangle);
  }

  std::shared_ptr<const MeshData> finish() {
    if (data_->faces.empty()) reader_.error("No triangles in triangle mesh.");
    if (data_->normals.empty()) data_->normal_indices.clear();
    if (data_->textures.empty()) data_->texture_indices.clear();
    if (!any_uv_) {
      data_->uvs.clear();
      data_->uv_indices.clear();
    }
    return data_;
  }

 private:
  struct VertexHash {
    std::size_t operator()(const glm::vec3& v) const {
      const std::hash<float> hash;
      return hash(v.x) * 73856093u ^ hash(v.y) * 19349663u ^ hash(v.z) * 83492791u;
    }
  };

  std::uint32_t vertex(const glm::vec3& v) {
    const auto [found, added] = vertex_index_.try_emplace(v, static_cast<std::uint32_t>(data_->vertices.size()));
    if (added) data_->vertices.push_back(v);
    return found->second;
  }

  void add_normals(const MeshTriangle& triangle) {
    MeshData::Indices indices = kNoIndices;
    if (triangle.smooth) {
      std::array<glm::vec3, 3> normals;
      for (std::size_t i = 0; i < 3; ++i) normals[i] = vertex_normal(reader_, triangle.normals[i], "mesh", warned_);
      if (!normals_are_equal(normals[0], normals[1], normals[2]))
        for (std::size_t i = 0; i < 3; ++i) {
          indices[i] = static_cast<std::uint32_t>(data_->normals.size());
          data_->normals.push_back(normals[i]);
        }
    }
    data_->normal_indices.push_back(indices);
  }

  void add_uv(const MeshTriangle& triangle) {
    if (data_->uvs.empty()) data_->uvs.push_back(dvec2(0));
    MeshData::Indices indices{0, 0, 0};
    if (triangle.uv) {
      any_uv_ = true;
      for (std::size_t i = 0; i < 3; ++i) {
        indices[i] = static_cast<std::uint32_t>(data_->uvs.size());
        data_->uvs.push_back((*triangle.uv)[i]);
      }
    }
    data_->uv_indices.push_back(indices);
  }

  void add_textures(const MeshTriangle& triangle) {
    MeshData::Indices indices = kNoIndices;
    for (std::size_t i = 0; i < 3; ++i)
      if (triangle.textures[i] != nullptr) indices[i] = textures_.index_of(triangle.textures[i]);
    data_->texture_indices.push_back(indices);
  }

  Reader& reader_;
  std::shared_ptr<MeshData> data_ = std::make_shared<MeshData>();
  MeshTextures textures_{*data_};
  std::unordered_map<glm::vec3, std::uint32_t, VertexHash> vertex_index_;
  bool warned_ = false, any_uv_ = false;
};

}  // namespace

Mesh parse_mesh(Reader& reader) {
  Mesh mesh;
  MeshCollector collector(reader);
  while (true) {
    if (reader.accept(Word::kTriangle)) collector.add(parse_mesh_triangle(reader, Word::kTriangle));
    else if (reader.accept(Word::kSmoothTriangle)) collector.add(parse_mesh_triangle(reader, Word::kSmoothTriangle));
    else if (reader.accept(Word::kInsideVector)) mesh.inside_vector = reader.vector();
    else break;
  }
  mesh.data = collector.finish();
  if (glm::length(mesh.inside_vector) < kEpsilon) mesh.inside_vector = dvec3(0);
  return mesh;
}

}  // namespace lute
