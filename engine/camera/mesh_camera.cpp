#include "engine/camera/mesh_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lute {
namespace {

using Corners = std::array<dvec2, 3>;

Corners uv_corners(const MeshData& mesh, std::size_t face) {
  if (mesh.uv_indices.empty()) return {};
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.uvs[mesh.uv_indices[face][c]];
  return corners;
}

TriangleTree flat_tree(const MeshData& mesh) {
  std::vector<glm::vec3> vertices;
  std::vector<TriangleTree::Face> faces;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    faces.push_back({first, first + 1, first + 2});
    for (const dvec2& uv : uv_corners(mesh, face)) vertices.emplace_back(glm::vec2(uv), 0.0f);
  }
  return TriangleTree(vertices, faces, [](std::uint32_t) { return false; });
}

std::array<double, 3> barycentric(const Corners& p, dvec2 at) {
  const auto area = [](dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; };
  const double whole = area(p[1] - p[0], p[2] - p[0]);
  const double second = area(at - p[0], p[2] - p[0]) / whole, third = area(p[1] - p[0], at - p[0]) / whole;
  return {1 - second - third, second, third};
}

}  // namespace

MeshCameraRays::MeshCameraRays(const Camera& camera, int width, int height)
    : description_(camera.mesh),
      width_(width),
      height_(height),
      offset_(camera.location.z),
      backwards_(camera.direction.z < -kEpsilon) {
  if (description_->distribution == MeshCamera::Distribution::kUvMap)
    uv_tree_.emplace(flat_tree(*description_->parts.front().data));
}

std::optional<MeshCameraRays::Spot> MeshCameraRays::in_row(std::size_t number) const {
  for (std::size_t mesh = 0; mesh < description_->parts.size(); ++mesh) {
    const std::size_t count = description_->parts[mesh].data->faces.size();
    if (number < count) return Spot{mesh, number};
    number -= count;
  }
  return std::nullopt;
}

std::optional<MeshCameraRays::Spot> MeshCameraRays::side_by_side(dvec2 cell) const {
  const double mesh_width = width_ / static_cast<double>(description_->parts.size());
  const auto mesh = static_cast<std::size_t>(cell.x / mesh_width);
  if (mesh >= description_->parts.size()) return std::nullopt;
  const double face = std::floor(cell.y) * std::floor(mesh_width) + std::floor(cell.x);
  return Spot{mesh, static_cast<std::size_t>(face)};
}

std::optional<MeshCameraRays::Spot> MeshCameraRays::on_uv_map(dvec2 cell) const {
  const dvec2 at((cell.x - 0.5) / width_, 1 - (cell.y + 0.5) / height_);
  thread_local std::vector<TriangleHit> found;
  found.clear();
  uv_tree_->all({{at, -1}, {0, 0, 1}}, {0, 2}, found);
  if (found.empty()) return std::nullopt;
  const std::size_t face = std::ranges::min_element(found, {}, &TriangleHit::face)->face;
  return Spot{0, face, barycentric(uv_corners(*description_->parts.front().data, face), at)};
}

std::optional<MeshCameraRays::Spot> MeshCameraRays::spot(dvec2 cell, int index) const {
  const double number = std::floor(cell.y) * width_ + std::floor(cell.x);
  switch (description_->distribution) {
    case MeshCamera::Distribution::kMeshOfRay:
      return Spot{static_cast<std::size_t>(index), static_cast<std::size_t>(number)};
    case MeshCamera::Distribution::kAllInARow:
      return index == 0 ? in_row(static_cast<std::size_t>(number)) : std::nullopt;
    case MeshCamera::Distribution::kSideBySide: return side_by_side(cell);
    case MeshCamera::Distribution::kUvMap: return on_uv_map(cell);
  }
  return std::nullopt;
}

dvec3 MeshCameraRays::normal(const Spot& spot) const {
  const MeshData& mesh = *description_->parts[spot.mesh].data;
  const dvec3 flat = glm::normalize(dvec3(mesh.face_normals[spot.face]));
  if (!description_->smooth || mesh.normal_indices.empty() || mesh.normal_indices[spot.face][0] == MeshData::kNone) return flat;
  dvec3 sum(0);
  for (std::size_t c = 0; c < 3; ++c) sum += spot.weights[c] * dvec3(mesh.normals[mesh.normal_indices[spot.face][c]]);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : flat;
}

bool MeshCameraRays::project(dvec2 position, int index, ProjectedRay& ray) const {
  // Half a pixel right of where it should be, half a pixel above: the reference's first two rows are one.
  const dvec2 cell(std::clamp(position.x + 0.5, 0.0, width_ - 1), std::clamp(position.y - 0.5, 0.0, height_ - 1));
  const std::optional<Spot> found = spot(cell, index);
  if (!found) return false;
  const MeshCamera::Part& part = description_->parts[found->mesh];
  if (found->face >= part.data->faces.size() || part.data->face_normals[found->face] == glm::vec3(0)) return false;

  dvec3 point(0);
  for (std::size_t c = 0; c < 3; ++c)
    point += found->weights[c] * dvec3(part.data->vertices[part.data->faces[found->face][c]]);
  const dvec3 outward = normal(*found);
  ray.origin = part.transform.point(point + offset_ * outward);
  ray.direction = part.transform.direction(backwards_ ? -outward : outward);
  ray.pattern_point = dvec2(0);
  if (description_->reach > 0) ray.reach = description_->reach;
  return true;
}

}  // namespace lute
