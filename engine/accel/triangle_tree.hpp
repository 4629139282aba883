// Indexed triangles, ready for rays: packed by fours into the leaves of a Bvh.
//
// The test of a triangle is that of Woop, Benthin and Wald, "Watertight ray/triangle intersection" (2013), in double
// precision: the corners are sheared along the ray, and the signs of three edge functions decide. Both triangles at an
// edge compute the edge's function from the same numbers, so no ray passes between them, and every edge belongs to
// both. Four triangles are tested at once.
//
// Of hits at exactly equal depth the one on the face with the highest number counts.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/accel/bvh.hpp"

namespace lute {

struct TriangleHit {
  double t = 0;  // in units of the direction's length
  std::uint32_t face = 0;
  std::array<double, 3> weights{};  // barycentric, of the face's corners
};

class TriangleTree {
 public:
  using Face = std::array<std::uint32_t, 3>;  // indices of vertices

  // Four triangles side by side; a lane without a triangle has all corners at 0 and is never hit.
  struct alignas(32) Block {
    float corner[3][3][4];  // [corner][axis][lane]
    std::array<std::uint32_t, 4> face;
  };

  // `skip(face)`: leave this one out. Faces with corners that are not finite are left out too.
  template <class Skip>
  TriangleTree(std::span<const glm::vec3> vertices, std::span<const Face> faces, Skip&& skip) {
    std::vector<std::uint32_t> used;
    used.reserve(faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
      if (!skip(f)) used.push_back(f);
    build(vertices, faces, used);
  }

  Aabb bounds() const { return bvh_.bounds(); }
  const Bvh& bvh() const { return bvh_; }
  std::span<const Block> blocks() const { return blocks_; }

  bool nearest(const Ray& ray, Interval range, TriangleHit& hit) const;
  bool any(const Ray& ray, Interval range) const;
  void all(const Ray& ray, Interval range, std::vector<TriangleHit>& hits) const;  // appended, in no particular order

  // How many triangles the ray crosses, where one that it meets on an edge or a corner counts as if the ray ran a
  // little beside it, always to the same side: the ray's origin is inside a closed surface exactly if the number is
  // odd.
  std::uint64_t crossings(const Ray& ray, Interval range) const;

 private:
  void build(std::span<const glm::vec3> vertices, std::span<const Face> faces, std::span<const std::uint32_t> used);
  void pack_leaves(std::span<const glm::vec3> vertices, std::span<const Face> faces);

  Bvh bvh_;
  std::vector<Block> blocks_;
};

}  // namespace lute
