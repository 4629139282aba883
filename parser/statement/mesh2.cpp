// mesh2 { vertex_vectors {...} ... face_indices {...} ... } (specification chapter 21 §3.3).
#include <algorithm>

#include "parser/diagnostic/advice.hpp"
#include "parser/session.hpp"
#include "parser/statement/mesh_builder.hpp"
#include "parser/statement/simple_shape.hpp"
#include "parser/statement/texture.hpp"

namespace lute {
namespace {

using Indices = MeshData::Indices;
constexpr std::uint32_t kNone = MeshData::kNone;

// What the lists of a mesh2 say, before they are checked against each other.
struct Mesh2Lists {
  std::vector<glm::vec3> vertices;
  std::vector<glm::vec3> normals;
  std::vector<dvec2> uvs;
  std::vector<TexturePtr> textures;
  bool vertices_given = false, normals_given = false, uvs_given = false;
  bool normals_warned = false;
};

int parse_list_size(Reader& reader) {
  const int size = reader.integer();
  reader.comma();
  return size;
}

// Room for a list of that size, so that it does not grow by copying. Untouched memory costs nothing.
template <class T>
void make_room(Reader& reader, std::vector<T>& list, int size) {
  const auto count = static_cast<std::size_t>(std::max(size, 0));
  reader.session().resources.charge(count * sizeof(T));
  list.reserve(count);
}

void warn_duplicate(Reader& reader, bool& given, Word keyword) {
  if (given) reader.warning("Duplicate " + std::string(spelling(keyword)) + " block; ignoring previous block.");
  given = true;
}

void parse_vertices(Reader& reader, Mesh2Lists& lists) {
  warn_duplicate(reader, lists.vertices_given, Word::kVertexVectors);
  reader.open(Word::kVertexVectors);
  lists.vertices.clear();
  const int size = parse_list_size(reader);
  if (size <= 0) reader.error("No vertices in triangle mesh.");
  make_room(reader, lists.vertices, size);
  for (int i = 0; i < size; ++i) {
    lists.vertices.push_back(single(reader.vector()));
    reader.comma();
  }
  reader.close(Word::kVertexVectors);
}

void parse_normals(Reader& reader, Mesh2Lists& lists) {
  warn_duplicate(reader, lists.normals_given, Word::kNormalVectors);
  reader.open(Word::kNormalVectors);
  lists.normals.clear();
  const int size = parse_list_size(reader);
  make_room(reader, lists.normals, size);
  for (int i = 0; i < size; ++i) {
    lists.normals.push_back(vertex_normal(reader, reader.vector(), "mesh2", lists.normals_warned));
    reader.comma();
  }
  reader.close(Word::kNormalVectors);
}

void parse_uvs(Reader& reader, Mesh2Lists& lists) {
  warn_duplicate(reader, lists.uvs_given, Word::kUvVectors);
  reader.open(Word::kUvVectors);
  lists.uvs.clear();
  const int size = parse_list_size(reader);
  make_room(reader, lists.uvs, size);
  for (int i = 0; i < size; ++i) {
    lists.uvs.push_back(reader.vector2());
    reader.comma();
  }
  reader.close(Word::kUvVectors);
}

void parse_textures(Reader& reader, Mesh2Lists& lists) {
  reader.open(Word::kTextureList);
  const int size = parse_list_size(reader);
  for (int i = 0; i < size; ++i) {
    if (const auto named = reader.accept_identifier<TexturePtr>()) {
      lists.textures.push_back(*named);
    } else {
      reader.expect(Word::kTexture);
      lists.textures.push_back(parse_texture(reader));
    }
    reader.comma();
  }
  reader.close(Word::kTextureList);
}

Mesh2Lists parse_lists(Reader& reader) {
  Mesh2Lists lists;
  while (true) {
    if (reader.accept(Word::kVertexVectors)) {
      parse_vertices(reader, lists);
    } else if (reader.accept(Word::kNormalVectors)) {
      parse_normals(reader, lists);
    } else if (reader.accept(Word::kUvVectors)) {
      parse_uvs(reader, lists);
    } else if (reader.accept(Word::kTextureList)) {
      parse_textures(reader, lists);
      break;
    } else {
      break;
    }
  }
  if (!lists.vertices_given) reader.error("Vertex vectors not found in mesh2");
  return lists;
}

Indices parse_index_triple(Reader& reader, std::size_t list_size, const char* message, const char* what) {
  const dvec3 written = reader.vector();
  Indices indices{};
  for (int i = 0; i < 3; ++i) {
    const double index = std::trunc(written[i]);
    if (!(index >= 0 && index < static_cast<double>(list_size))) {
      reader.error(message, "scene-error", index_advice(what, list_size, index));
    }
    indices[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(index);
  }
  return indices;
}

// face_indices { n, <a, b, c> [, t1 [, t2, t3]] ... }
void parse_faces(Reader& reader, const Mesh2Lists& lists, MeshData& data) {
  reader.expect(Word::kFaceIndices);
  reader.open(Word::kFaceIndices);
  const int size = parse_list_size(reader);
  if (size <= 0) reader.error("No triangles in triangle mesh.");
  make_room(reader, data.faces, size);
  if (!lists.textures.empty()) make_room(reader, data.texture_indices, size);
  for (int i = 0; i < size; ++i) {
    data.faces.push_back(parse_index_triple(reader, data.vertices.size(), "Mesh face index out of range.", "the vertices"));
    reader.comma();
    Indices textures{kNone, kNone, kNone};
    for (std::uint32_t& texture : textures) {
      // A vector is the next face: only a lone number is a texture.
      if (reader.at(TokenKind::kLess) || reader.at(TokenKind::kRightBrace)) break;
      const auto number = reader.optional_number();
      if (!number) break;
      reader.comma();
      if (!(*number >= 0 && std::trunc(*number) < static_cast<double>(lists.textures.size())))
        reader.error("Texture index out of range in mesh2.", "scene-error", index_advice("the textures", lists.textures.size(), *number));
      texture = static_cast<std::uint32_t>(*number);
    }
    if (textures[1] == kNone || textures[2] == kNone) textures[1] = textures[2] = kNone;
    if (!lists.textures.empty()) data.texture_indices.push_back(textures);
  }
  reader.close(Word::kFaceIndices);
}

// `fits`: whether a list may have that size.
template <class Fits>
std::vector<Indices> parse_index_list(Reader& reader, Word keyword, std::size_t list_size, const char* message, const char* what,
                                      Fits fits, const char* size_message) {
  reader.open(keyword);
  std::vector<Indices> list;
  const int size = parse_list_size(reader);
  if (!fits(static_cast<std::size_t>(std::max(size, 0)))) reader.error(size_message);
  make_room(reader, list, size);
  for (int i = 0; i < size; ++i) {
    list.push_back(parse_index_triple(reader, list_size, message, what));
    reader.comma();
  }
  reader.close(keyword);
  return list;
}

// What is missing is taken from the faces, or one entry serves all.
void settle_uv(Reader& reader, MeshData& data, std::optional<std::vector<Indices>>& written) {
  if (written) {
    data.uv_indices = std::move(*written);
  } else if (data.uvs.size() == data.vertices.size()) {
    data.uv_indices = data.faces;
  } else if (data.uvs.size() == 1) {
    data.uv_indices.assign(data.faces.size(), Indices{0, 0, 0});
  } else if (!data.uvs.empty()) {
    reader.error("Missing uv_indicies section in mesh2.");
  }
}

void settle_normals(Reader& reader, MeshData& data, std::optional<std::vector<Indices>>& written) {
  if (written) {
    data.normal_indices = std::move(*written);
    data.normal_indices.resize(data.faces.size(), Indices{kNone, kNone, kNone});
  } else if (data.normals.empty()) {
    return;
  } else if (data.normals.size() == data.vertices.size()) {
    data.normal_indices = data.faces;
  } else {
    reader.error("Missing normal_indicies section in mesh2.");
  }
  for (Indices& i : data.normal_indices)
    if (i[0] != kNone && normals_are_equal(data.normals[i[0]], data.normals[i[1]], data.normals[i[2]]))
      i = {kNone, kNone, kNone};
}

void compute_face_normals(MeshData& data) {
  data.face_normals.reserve(data.faces.size());
  const auto vertex = [&](std::uint32_t i) { return dvec3(data.vertices[i]); };
  for (const Indices& face : data.faces)
    data.face_normals.push_back(single(face_normal({vertex(face[0]), vertex(face[1]), vertex(face[2])})));
}

}  // namespace

Mesh parse_mesh2(Reader& reader) {
  Mesh2Lists lists = parse_lists(reader);
  auto data = std::make_shared<MeshData>();
  data->vertices = std::move(lists.vertices);
  data->normals = std::move(lists.normals);
  data->uvs = std::move(lists.uvs);
  data->textures.assign(lists.textures.begin(), lists.textures.end());
  parse_faces(reader, lists, *data);
  if (data->textures.empty()) data->texture_indices.clear();

  const std::size_t faces = data->faces.size();
  const auto as_many = [faces](std::size_t size) { return size == faces; };
  const auto no_more = [faces](std::size_t size) { return size <= faces; };
  std::optional<std::vector<Indices>> uv, normals;
  while (true) {
    if (!uv && reader.accept(Word::kUvIndices))
      uv = parse_index_list(reader, Word::kUvIndices, data->uvs.size(), "Mesh UV index out of range.", "the uv vectors",
                            as_many, "Number of uv indices must equal number of faces.");
    else if (!normals && reader.accept(Word::kNormalIndices))
      normals = parse_index_list(reader, Word::kNormalIndices, data->normals.size(), "Mesh normal index out of range.",
                                 "the normals", no_more, "Number of normal indices cannot be more than the number of faces.");
    else break;
  }
  settle_uv(reader, *data, uv);
  settle_normals(reader, *data, normals);
  compute_face_normals(*data);

  Mesh mesh;
  if (reader.accept(Word::kInsideVector)) mesh.inside_vector = reader.vector();
  if (glm::length(mesh.inside_vector) < kEpsilon) mesh.inside_vector = dvec3(0);
  mesh.data = std::move(data);
  return mesh;
}

}  // namespace lute
