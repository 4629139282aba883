// The interface of a compiled primitive: what the renderer asks of a shape. Everything is in world space; a shape keeps its own
// transformation and, where the reference does, measures its tolerances in its own space (specification chapter 20 §2, §9).
//
// To add a primitive, write `engine/shape/<name>.{hpp,cpp}` with
//   * a plain struct, its description as the scene file says it, with `static constexpr std::string_view kKeyword`;
//   * `std::unique_ptr<Shape> build(const Name&, const SharedTransform& to_world, BuildContext&)`;
// and add
//   * its include and its alternative to `engine/shape/table.hpp`;
//   * its keyword to LUTE_WORDS (`parser/lexer/word.hpp`), if the language does not know the word yet;
//   * a parser to one of `parser/statement/*_shape.{hpp,cpp}`, and its line in kPrimitives (`parser/statement/primitive.cpp`);
//   * `fields(const Name&)` to `parser/dump/shape.cpp`, which does not compile without.
// Tests: a case in tests/engine/shape/shape_cases.cpp for those that every shape passes, a scene in scenes/feature/shape, a dense one in
// bench/scene. A test says so if a keyword is missing from the parser. See sphere.hpp and box.cpp for small ones.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/math/aabb.hpp"
#include "engine/math/interval.hpp"
#include "engine/math/ray.hpp"
#include "engine/memory/shared_transform.hpp"

namespace lute {

// One crossing of a ray with a shape's surface. `part` and `data` belong to the shape that made it: whatever its normal() needs
// (a face number, barycentric coordinates, a recorded normal). Normals are computed for the hit that survives only.
struct ShapeHit {
  double t = 0;  // world depth along the ray's unit direction
  std::uint32_t part = 0;
  std::array<double, 3> data{};
};

// Hits in the order in which the shape finds them: of several at exactly equal depth the last one wins (chapter 20 §2.2).
using ShapeHits = std::vector<ShapeHit>;

// A share of the surface's colour: texture `index` of the description's own textures (mesh triangles, blob components).
struct TextureWeight {
  std::uint32_t index = 0;  // kObjectTexture: the texture of the object
  float weight = 1;
  static constexpr std::uint32_t kObjectTexture = 0xFFFFFFFF;
};

// In which intersections a shape is asked where along a ray it lies, before the others are searched for hits.
enum class RayLimits : std::uint8_t {
  kNever,
  kForDear,  // with a shape that prefers a shorter range
  kAlways
};

class Shape {
 public:
  virtual ~Shape() = default;

  // Closed box around the whole surface and, for solids, the inside. May be infinite.
  virtual Aabb bounds() const = 0;

  // Box around the points that inside() accepts, where that differs: the half space behind a disc or a plane.
  virtual Aabb inside_bounds() const { return bounds(); }

  // Boxes that hold the part of the surface, and of the points which inside() or inside_inverted() accepts, that lies in `region`.
  // A shape without bounds may have some here: a cone between two planes.
  virtual Aabb surface_within(const Aabb& region) const { return region.intersection(bounds()); }
  virtual Aabb inside_within(const Aabb& region, bool inverted) const {
    return inverted ? region : region.intersection(inside_bounds());
  }

  // Appends all hits with depth in `range`, and above the shape's own tolerance.
  virtual void hits(const Ray& ray, Interval range, ShapeHits& out) const = 0;

  // The nearest hit in `range`, or false. The default takes it from hits().
  virtual bool nearest(const Ray& ray, Interval range, ShapeHit& hit) const;

  // True if anything is hit in `range`: a shadow test. The default asks nearest().
  virtual bool any(const Ray& ray, Interval range) const;

  // The reference's inside test, with its tolerance, for the shape as written (not inverted). Patches have no inside.
  virtual bool inside(const dvec3& point) const = 0;
  virtual bool is_patch() const { return false; }

  // Inside test of the shape with `inverse`; differs from !inside() where the surface counts as outside of both (sphere) or
  // inside of both (plane).
  virtual bool inside_inverted(const dvec3& point) const { return !inside(point); }

  // Raw outward unit normal at a hit (not turned toward the ray, not negated for `inverse`).
  virtual dvec3 normal(const ShapeHit& hit, const dvec3& point) const = 0;

  // Whether clipped_by removes hits. Not from a bicubic patch (chapter 21 §5.4).
  virtual bool obeys_clips() const { return true; }

  // Whether `inverse` negates the raw normal. Not for a quadric, which negates its coefficients too (chapter 20 §5.7).
  virtual bool inverse_turns_normal() const { return !is_patch(); }

  // Surface coordinates for uv_mapping. Default: x and y of the world point (chapter 20 §3).
  virtual dvec2 uv(const ShapeHit& hit, const dvec3& point) const;

  // Appends the textures that share the point. The default: the object's texture, weight 1.
  virtual void textures(const ShapeHit& hit, const dvec3& point, std::vector<TextureWeight>& out) const;

  // False for shapes that the reference tests without their own bounding box (sphere, box, plane, poly family).
  virtual bool tests_own_box() const { return true; }

  // True where the boxes of the shape are found as fast as they could be read: nobody needs to keep them.
  virtual bool finds_bounds_fast() const { return false; }

  // True where finding a hit costs so much, and a shorter range so much less, that clips and other members of an intersection
  // are asked first where along the ray they are.
  virtual bool prefers_clipped_range() const { return false; }

  // For shapes that divide a ray fast. Takes from a stretch of a ray what is outside of the shape (inside, when inverted), a
  // little generously, so that no point is lost that the inside test accepts. False if nothing is left.
  virtual RayLimits limits_rays() const { return RayLimits::kNever; }
  virtual bool limit(const Ray&, bool /*inverted*/, Interval&) const { return true; }
};

// What building a shape may need besides its description: caches shared by all copies of one description in a scene.
class BuildContext {
 public:
  virtual ~BuildContext() = default;

  // A compiled form shared by every copy of one description (for example the tree of a mesh). `key` is the address of the shared
  // data. Returns null when nothing is stored yet.
  virtual std::shared_ptr<const void> find_shared(const void* key) const = 0;
  virtual void store_shared(const void* key, std::shared_ptr<const void> value) = 0;
};

}  // namespace lute
