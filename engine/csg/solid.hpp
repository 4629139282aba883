// The built scene's objects: a leaf (one shape with what it looks like) or a combination of solids (CSG), in world space.
// Source: specification chapter 20 §2, §3, §6, §7.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/memory/shared_transform.hpp"
#include "engine/shape/shape.hpp"

namespace lute {

struct CompiledTexture;  // engine/texture/compiled_texture.hpp
struct BuiltInterior;    // engine/build/built_scene.hpp
class Solid;
class CsgSolid;

// Which rays see an object (chapter 40 §2). A ray carries the set of kinds that apply to it. Bits, since every query of a ray passes them on.
struct RayKind {
  bool primary : 1 = true;
  bool reflected : 1 = false;
  bool refracted : 1 = false;
  bool shadow : 1 = false;
  bool radiosity : 1 = false;
  bool photon : 1 = false;
};

struct Visibility {
  bool no_image : 1 = false, no_reflection : 1 = false, no_radiosity : 1 = false, no_shadow : 1 = false;
  bool restricts() const { return no_image || no_reflection || no_radiosity || no_shadow; }
  bool visible_to(RayKind kind) const {
    if (kind.shadow) return !no_shadow;
    if (!restricts()) return true;
    const bool image = kind.primary || (kind.refracted && !kind.reflected);
    if (no_image && image) return false;
    if (no_reflection && kind.reflected) return false;
    if (no_radiosity && kind.radiosity) return false;
    return !(no_shadow && kind.photon);
  }
};

// A texture in the built scene, and from the space that it was written in to the world.
struct PlacedTexture {
  const CompiledTexture* texture = nullptr;
  SharedTransform to_world;
};

// The textures that few leaves have beside their own.
struct FurtherTextures {
  PlacedTexture inner;               // interior_texture; null: none
  std::vector<PlacedTexture> parts;  // what TextureWeight::index selects
};

// One shape of the built scene and what it looks like. Small, for there may be millions of them.
struct Leaf {
  std::unique_ptr<Shape> shape;
  PlacedTexture texture;              // null: taken from the cutaway parent, or black
  Shared<FurtherTextures> further;
  BuiltInterior* interior = nullptr;  // shared by the parts of a CSG
  int light_group = -1;               // index into the built scene's groups; -1: none
  bool global_lights = true;
  bool inverted : 1 = false;
  bool uv_mapping : 1 = false;
  bool double_illuminate : 1 = false;
  bool opaque : 1 = false;            // no texture of it lets light through: a shadow ray ends here

  bool has_part_textures() const { return !further.is_default() && !further->parts.empty(); }
  const PlacedTexture& texture_of_side(bool from_inside) const {
    return from_inside && !further.is_default() && further->inner.texture != nullptr ? further->inner : texture;
  }
};

struct Hit {
  double t = 0;
  dvec3 point{0};
  ShapeHit shape_hit;
  const Leaf* leaf = nullptr;
  const CsgSolid* cutaway = nullptr;  // the outermost CSG that marks the hit: asked when the leaf has no texture
};
using Hits = std::vector<Hit>;

// `visibility` of a top-level solid is tested by whoever holds the scene's objects; a CsgSolid tests that of its children.
class Solid {
 public:
  virtual ~Solid() = default;

  // All hits with depth in `range` that survive clips, bounds and CSG, in the order in which ties are decided (last wins).
  virtual void hits(const Ray& ray, Interval range, RayKind kind, Hits& out) const = 0;
  virtual bool nearest(const Ray& ray, Interval range, RayKind kind, Hit& hit) const;
  virtual bool any(const Ray& ray, Interval range, RayKind kind) const;

  virtual bool inside(const dvec3& point) const = 0;        // inside test including own clips
  virtual bool plain_inside(const dvec3& point) const = 0;  // without own clips: camera containment, cutaway
  virtual void leaves(std::vector<const Leaf*>& out) const = 0;

  // False where box() has to be found each time, but a ray is tested against the solid as fast.
  bool keeps_box() const { return boxes_ != nullptr; }
  // Around every hit: bounds after CSG rules, clips and bounded_by.
  Aabb box() const { return boxes_ != nullptr ? boxes_->hits : own_box(); }
  // Around every point that inside() accepts.
  Aabb inside_box() const { return boxes_ != nullptr ? boxes_->inside : own_inside_box(); }
  // False for some points that inside() refuses: fast where inside() is not.
  bool may_contain(const dvec3& point) const { return boxes_ == nullptr || boxes_->inside.contains(point); }

  // Boxes around the hits and around the points accepted by inside() that lie in `region`; within box() and inside_box().
  virtual Aabb hits_within(const Aabb& region) const = 0;
  virtual Aabb inside_within(const Aabb& region) const = 0;
  // hits_within for a region that inside_within has made, which is not to be made smaller by the same means again.
  virtual Aabb hits_inside(const Aabb& region) const { return hits_within(region); }
  // Box around the points that inside() refuses: finite for what was inverted, the cutters of a difference.
  virtual Aabb outside_bounds() const { return Aabb::infinite(); }

  struct Boxes {
    Aabb hits, inside = Aabb::infinite();
    virtual ~Boxes() = default;
  };

 protected:
  // Asked where no boxes are kept: of a solid that finds them as fast as it could read them.
  virtual Aabb own_box() const { return Aabb::infinite(); }
  virtual Aabb own_inside_box() const { return Aabb::infinite(); }

  std::unique_ptr<Boxes> boxes_;

 public:
  Visibility visibility;
  bool opaque = false;  // every leaf is opaque
};

}  // namespace lute
