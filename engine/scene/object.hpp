// Objects as the scene file says them: a shape, a combination (CSG) or a light, with its modifiers. Plain values, shared and
// never changed once shared. Source: specification chapters 11 §7-8, §14 and 20 §6-8.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "engine/memory/shared.hpp"
#include "engine/memory/shared_transform.hpp"
#include "engine/scene/interior.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"
#include "engine/shape/table.hpp"

namespace lute {

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

enum class CsgOperation : std::uint8_t { kUnion, kMerge, kIntersection, kDifference, kLightGroup };

// What objects are made of, with all that is in their parts: known without a walk through them, of which there may be more than fit
// into any memory (an object can be twice in a union that is twice in a union ...). See engine/scene/contents.hpp.
struct Contents {
  std::uint32_t depth = 0;       // of objects, textures and functions inside each other
  double leaves = 0;             // shapes and lights, as often as they are met
  bool textured = false;
  bool patches = false;          // something without an inside, which leaves the whole without one; lights count
  bool media_densities = false;  // in an interior
};

struct Csg {
  CsgOperation operation = CsgOperation::kUnion;
  std::vector<ObjectPtr> children;  // in the order written; of a difference all but the first are cutters
  bool split_union = true;
  bool cutaway_textures = false;
  Contents contents;  // of the children
};

// What few objects have: together behind one pointer, so that the many do without.
struct ObjectExtras {
  TextureOnObject interior_texture;
  TexturePtr default_texture;  // of a top-level object: the default in force at its end, for parts without texture; null: built-in
  InteriorPtr interior;
  std::vector<ObjectPtr> clipped_by;  // at their final place in this object's parent space
  std::vector<ObjectPtr> bounded_by;
  Contents limits;                    // of the clips and bounds
  std::optional<bool> global_lights;  // light_group and what it passes down
  std::optional<bool> photon_refraction, photon_reflection;
  bool photon_target = false, photon_pass_through = false, photon_collect = true;
  float photon_density = 1;
  std::optional<float> radiosity_importance;
};

// Small, for there may be millions of them.
struct Object {
  std::variant<Shared<Csg>, AnyShape, Shared<LightSource>> geometry;
  SharedTransform transform;  // this object's own modifiers, in order; the shape, or all children, are moved by it
  TextureOnObject texture;
  Shared<ObjectExtras> extras;

  std::optional<bool> hollow;  // unset: not given on this object
  bool uv_mapping : 1 = false;
  bool inverse : 1 = false;
  bool no_shadow : 1 = false, no_image : 1 = false, no_reflection : 1 = false, no_radiosity : 1 = false;
  bool double_illuminate : 1 = false;
  bool declared : 1 = false;  // combinations: was given a name, so that what stands in the scene is a copy

  SourceLocation where;

  // What it is; null for the other kinds. Those that edit make sure that no copy sees the changes.
  const AnyShape* shape() const { return std::get_if<AnyShape>(&geometry); }
  const Csg* csg() const { return value(std::get_if<Shared<Csg>>(&geometry)); }
  const LightSource* light() const { return value(std::get_if<Shared<LightSource>>(&geometry)); }
  AnyShape* edit_shape() { return std::get_if<AnyShape>(&geometry); }
  Csg* edit_csg() { return own(std::get_if<Shared<Csg>>(&geometry)); }
  LightSource* edit_light() { return own(std::get_if<Shared<LightSource>>(&geometry)); }

  template <class Shape>
  const Shape* shape_if() const {
    return shape() != nullptr ? shape()->get_if<Shape>() : nullptr;
  }

 private:
  template <class T>
  static const T* value(const Shared<T>* held) {
    return held != nullptr ? &**held : nullptr;
  }
  template <class T>
  static T* own(Shared<T>* held) {
    return held != nullptr ? &held->edit() : nullptr;
  }
};
static_assert(sizeof(Object) <= 72);

}  // namespace lute
