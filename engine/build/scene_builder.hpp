// From the description to the built scene: what goes down from an object to its parts, and what is made of each.
// Source: specification chapters 11 §14.1 (inheritance), 20 §6-8 and 40 §10.5.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/build/built_scene.hpp"
#include "engine/csg/csg_solid.hpp"

namespace lute {

// Compiled forms that copies of one description share: trees of meshes, images of height fields.
class SharedForms final : public BuildContext {
 public:
  std::shared_ptr<const void> find_shared(const void* key) const override {
    const auto it = forms_.find(key);
    return it == forms_.end() ? nullptr : it->second;
  }
  void store_shared(const void* key, std::shared_ptr<const void> value) override { forms_[key] = std::move(value); }

 private:
  std::map<const void*, std::shared_ptr<const void>> forms_;
};

class SceneBuilder {
 public:
  SceneBuilder(BuiltScene& built, const BuildOptions& options) : built_(built), options_(options) {
    if (built.scale != 1) unit_.to_world = unit_.parent_to_world = Transform::scale(dvec3(built.scale));
  }

  // How many top-level solids add() makes of an object.
  long count_solids(const Object& object) const;
  // Below the bounding threshold the reference tests spheres, boxes, planes and polynomials without any box: the box of a discarded
  // bounding object then cuts nothing (chapter 20 §7.3).
  void use_hierarchy(bool used) { hierarchy_used_ = used; }

  // Whether the scene asks what contains a point.
  void keep_containers(bool kept) { containers_kept_ = kept; }

  // A top-level object: one solid, several (a union that is dissolved), or none (a light).
  void add(const ObjectPtr& object);

  // The same without looks: for questions about geometry alone.
  void add_geometry(const ObjectPtr& object);

  // After the last object: lights of groups are joined, the tree is built.
  void finish();

 private:
  // A texture in the scene: the description and where it was written.
  struct Placed {
    TexturePtr texture;
    SharedTransform to_world;
  };

  // What an object has once everything that its parents pass down is known; and passes on.
  struct Context {
    SharedTransform to_world, parent_to_world;
    Placed texture, interior_texture;
    bool uv_mapping = false;
    BuiltInterior* interior = nullptr;
    Visibility visibility;
    bool cutaway = false;           // asked for, here or above
    bool stays_untextured = false;  // the parent supplies textures by cutaway
    bool double_illuminate = false;
    bool inverted = false;          // inverted as a whole
    std::optional<bool> hollow;     // of the outermost object that gives it
    bool declared = false;          // here or above
    bool in_light_group = false;
    int light_group = -1;           // whose lights light it: an index into the built scene's groups; -1: none
    int member_group = -1;          // the same of the shapes that are direct members of the light_group
    int form_group = -1;            // the same of what the direct members look like
    bool global_lights = true;
    bool group_member = false;      // a direct member of light_group: its lights are local
  };

  using SolidList = std::vector<std::unique_ptr<Solid>>;

  // appearance.cpp
  Context resolve(const Object& object, const Context& parent);
  void pass_textures(const Object& object, const Context& parent, Context& own);
  void settle_interior(const Object& object, const Context& own);
  BuiltInterior* new_interior(const InteriorPtr& description);
  PlacedTexture place(const Placed& placed);
  void dress(const Object& object, const Context& own, Leaf& leaf);
  void dress_parts(const Object& object, const Context& own, Leaf& leaf);
  static TexturePtr built_in_texture();

  // object_builder.cpp
  void add_top_level(const Object& object, const Context& parent);
  std::unique_ptr<Solid> solid(const Object& object, const Context& own, bool top_level);
  std::unique_ptr<Solid> leaf(const Object& object, const Context& own, bool top_level);
  std::unique_ptr<Solid> combination(const Object& object, const Csg& csg, const Context& own);
  SolidList children(const Object& object, const Csg& csg, const Context& own);
  void add_part(const Object& object, const Context& own, CsgKind outer, SolidList& parts);
  Context context_for_children(const Object& object, const Csg& csg, const Context& own);
  bool dissolves(const Object& object, const Csg& csg, const Context& own) const;
  struct Limits {
    SharedSolids clips, bounds;
  };
  Limits limits(const Object& object, const Context& own);
  void add_container(const Solid& solid, const Context& own);

  // light_builder.cpp
  void add_light(const LightSource& light, const Context& own);
  static Context context_for_form(const Context& of_light);  // of what the light looks like
  void enter_light_group(const Object& object, const Csg& group, const Context& parent, Context& own);
  int open_light_group();

  BuiltScene& built_;
  BuildOptions options_;
  Context unit_;  // of the whole scene: from its own units to those of the built scene
  SharedForms shared_;
  // Made first: the address of a description that went must not be that of another one.
  const TexturePtr built_in_texture_ = built_in_texture();
  TexturePtr default_texture_;       // of the statement being built; null: the built-in one
  struct JoinedGroup {               // a light group that has the lights of two others
    int whole, inner, outer;
  };
  std::vector<JoinedGroup> joined_groups_;
  std::map<const Interior*, Shared<InteriorProperties>> interior_properties_;  // of descriptions that are built
  bool hierarchy_used_ = true;
  bool containers_kept_ = false;
  bool geometry_only_ = false;  // clips, bounds, questions: looks do not matter
};

// Whether any part of the object has a texture of its own.
bool holds_texture(const Object& object);

}  // namespace lute
