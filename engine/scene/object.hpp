// Objects as the scene file says them: a shape, a combination (CSG) or a light, with its modifiers. Plain values, shared and
// never changed once shared. Source: specification chapters 11 §7-8, §14 and 20 §6-8.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "engine/math/transform.hpp"
#include "engine/scene/interior.hpp"
#include "engine/scene/light.hpp"
#include "engine/scene/source_location.hpp"
#include "engine/scene/texture.hpp"
#include "engine/shape/table.hpp"

namespace lute {

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

enum class CsgOperation : std::uint8_t { kUnion, kMerge, kIntersection, kDifference, kLightGroup };

struct Csg {
  CsgOperation operation = CsgOperation::kUnion;
  std::vector<ObjectPtr> children;  // in the order written; of a difference all but the first are cutters
  bool split_union = true;
  bool cutaway_textures = false;
};

struct Object {
  std::variant<AnyShape, Csg, LightSource> geometry;
  Transform transform;  // this object's own modifiers, in order; the shape, or all children, are moved by it

  TextureOnObject texture, interior_texture;
  TexturePtr default_texture;  // of a top-level object: the default in force at its end, for parts without texture; null: built-in
  bool uv_mapping = false;
  InteriorPtr interior;
  std::vector<ObjectPtr> clipped_by;  // at their final place in this object's parent space
  std::vector<ObjectPtr> bounded_by;

  bool inverse = false;
  bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
  bool double_illuminate = false;
  std::optional<bool> hollow;        // unset: not given on this object
  std::optional<bool> global_lights; // light_group and what it passes down
  std::optional<bool> photon_refraction, photon_reflection;
  bool photon_target = false, photon_pass_through = false, photon_collect = true;
  float photon_density = 1;
  std::optional<float> radiosity_importance;

  SourceLocation where;
};

}  // namespace lute
