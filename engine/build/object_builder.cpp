// Shapes and combinations. Source: specification chapter 20 §6-7.
#include <algorithm>
#include <iterator>

#include "engine/build/scene_builder.hpp"

namespace lute {
namespace {

CsgKind kind_of(CsgOperation operation) {
  switch (operation) {
    case CsgOperation::kMerge: return CsgKind::kMerge;
    case CsgOperation::kIntersection: return CsgKind::kIntersection;
    case CsgOperation::kDifference: return CsgKind::kDifference;
    case CsgOperation::kUnion:
    case CsgOperation::kLightGroup: break;
  }
  return CsgKind::kUnion;
}

// What is built of a combination that stands where `inverse` is in force or not.
CsgKind kind_of(const Csg& csg, bool inverse) {
  const CsgKind kind = kind_of(csg.operation);
  return inverse ? inverted(kind) : kind;
}

bool has_limits(const Object& object) { return !object.extras->clipped_by.empty() || !object.extras->bounded_by.empty(); }

bool is_light(const Object& object) { return object.light() != nullptr; }

// The shapes whose bounding object is kept at top level (§7.2).
bool keeps_bounds(const AnyShape& shape) {
  return shape.get_if<Poly>() != nullptr || shape.get_if<Text>() != nullptr;
}

}  // namespace

void SceneBuilder::add(const ObjectPtr& object) {
  default_texture_ = object->extras->default_texture;
  add_top_level(*object, unit_);
}

void SceneBuilder::add_geometry(const ObjectPtr& object) {
  geometry_only_ = true;
  add(object);
}

void SceneBuilder::add_top_level(const Object& object, const Context& parent) {
  const Context own = resolve(object, parent);
  if (const LightSource* light = object.light()) {
    if (!geometry_only_) add_light(*light, own);
    if (light->looks_like != nullptr) add_top_level(*light->looks_like, context_for_form(own));
    return;
  }
  const Csg* csg = object.csg();
  if (csg != nullptr && dissolves(object, *csg, own)) {
    const Context down = context_for_children(object, *csg, own);
    for (const ObjectPtr& child : csg->children) add_top_level(*child, down);
    return;
  }
  std::unique_ptr<Solid> built = solid(object, own, true);
  add_container(*built, own);
  built_.solids.push_back(std::move(built));
}

long SceneBuilder::count_solids(const Object& object) const {
  if (is_light(object)) return 1;  // with what it looks like
  const Csg* csg = object.csg();
  Context own;
  own.inverted = object.inverse;
  if (csg == nullptr || !dissolves(object, *csg, own)) return 1;
  long count = 0;
  for (const ObjectPtr& child : csg->children) count += count_solids(*child);
  return count;
}

bool SceneBuilder::dissolves(const Object& object, const Csg& csg, const Context& own) const {
  if (kind_of(csg.operation) != CsgKind::kUnion || own.inverted) return false;
  return csg.split_union && !has_limits(object);
}

std::unique_ptr<Solid> SceneBuilder::solid(const Object& object, const Context& own, bool top_level) {
  if (const Csg* csg = object.csg()) return combination(object, *csg, own);
  std::unique_ptr<Solid> built = leaf(object, own, top_level);
  const bool text = object.shape()->get_if<Text>() != nullptr;
  if (!text || top_level || own.inverted || !own.visibility.restricts()) return built;
  // To the language text is a union of letters, each with the flags: what does not see them passes, in an intersection too.
  SolidList letters;
  letters.push_back(std::move(built));
  auto whole = std::make_unique<CsgSolid>(CsgKind::kUnion, std::move(letters));
  whole->visibility = own.visibility;
  return whole;
}

std::unique_ptr<Solid> SceneBuilder::leaf(const Object& object, const Context& own, bool top_level) {
  const AnyShape& shape = *object.shape();
  Leaf leaf;
  leaf.shape = shape.visit([&](const auto& s) { return build(s, own.to_world, shared_); });
  if (shape.get_if<Isosurface>() != nullptr) built_.isosurfaces.push_back({leaf.shape.get(), object.where});
  leaf.inverted = own.inverted;
  leaf.double_illuminate = own.double_illuminate;
  leaf.interior = own.interior;
  const bool joins_groups = own.group_member && shape.get_if<Text>() == nullptr;
  leaf.light_group = joins_groups ? own.member_group : own.light_group;
  leaf.global_lights = own.global_lights;
  if (!geometry_only_) dress(object, own, leaf);

  Limits limit = limits(object, own);
  const bool box_only = top_level && options_.remove_bounds && !keeps_bounds(shape);
  if (box_only && !hierarchy_used_ && !leaf.shape->tests_own_box()) limit.bounds.clear();
  const bool box_tested = leaf.shape->tests_own_box() || (top_level && hierarchy_used_);
  auto built = std::make_unique<LeafSolid>(std::move(leaf), std::move(limit.clips), std::move(limit.bounds),
                                           box_only ? BoundTest::kBoxOnly : BoundTest::kTested, box_tested);
  built->visibility = own.visibility;
  return built;
}

std::unique_ptr<Solid> SceneBuilder::combination(const Object& object, const Csg& csg, const Context& own) {
  const CsgKind kind = kind_of(csg, own.inverted);
  SolidList parts = children(object, csg, own);
  Visibility visibility = own.visibility;
  // A union of nothing but no_shadow parts casts none as a whole (§6.6).
  if (kind == CsgKind::kUnion && !parts.empty())
    visibility.no_shadow =
        visibility.no_shadow || std::ranges::all_of(parts, [](const auto& part) { return part->visibility.no_shadow; });
  Limits limit = limits(object, own);
  auto built = std::make_unique<CsgSolid>(kind, std::move(parts), std::move(limit.clips), std::move(limit.bounds));
  built->visibility = visibility;
  return built;
}

SceneBuilder::SolidList SceneBuilder::children(const Object& object, const Csg& csg, const Context& own) {
  const Context down = context_for_children(object, csg, own);
  const CsgKind kind = kind_of(csg, own.inverted);
  SolidList parts;
  for (std::size_t i = 0; i < csg.children.size(); ++i) {
    const Object& child = *csg.children[i];
    Context parent = down;
    if (csg.operation == CsgOperation::kDifference && i > 0) parent.inverted = !parent.inverted;
    add_part(child, resolve(child, parent), kind, parts);
  }
  return parts;
}

// An intersection in an intersection is dissolved: a hit is asked once for each part, not once for each part and level. In reverse,
// since among hits of equal depths the order turns around at every level. Cut surfaces that lack a texture ask the levels, so these stay.
void SceneBuilder::add_part(const Object& object, const Context& own, CsgKind outer, SolidList& parts) {
  if (const LightSource* light = object.light()) {
    if (!geometry_only_) add_light(*light, own);
    const Object* const form = light->looks_like.get();  // a light counts as that
    if (form != nullptr) add_part(*form, resolve(*form, context_for_form(own)), outer, parts);
    return;
  }
  const Csg* csg = object.csg();
  const bool dissolved = csg != nullptr && all_children_needed(outer) && all_children_needed(kind_of(*csg, own.inverted)) &&
                         !has_limits(object) && !own.cutaway;
  if (!dissolved) {
    parts.push_back(solid(object, own, false));
    return;
  }
  SolidList inner = children(object, *csg, own);  // none, if it is nothing but lights: every point is inside
  std::move(inner.rbegin(), inner.rend(), std::back_inserter(parts));
}

SceneBuilder::Context SceneBuilder::context_for_children(const Object&, const Csg& csg, const Context& own) {
  Context down = own;
  down.stays_untextured = down.cutaway && all_children_needed(kind_of(csg, own.inverted));
  down.group_member = csg.operation == CsgOperation::kLightGroup;
  return down;
}

SceneBuilder::Limits SceneBuilder::limits(const Object& object, const Context& own) {
  Limits result;
  const ObjectExtras& extras = *object.extras;
  if (extras.clipped_by.empty() && extras.bounded_by.empty()) return result;
  // They are at their place in the space of the object's parent: the object's own transformation does not move them.
  Context parent;
  parent.to_world = own.parent_to_world;
  const bool outer = geometry_only_;
  geometry_only_ = true;
  std::map<const Object*, std::shared_ptr<const Solid>> built;
  const auto build_all = [&](const std::vector<ObjectPtr>& objects, SharedSolids& out) {
    for (const ObjectPtr& limit : objects) {
      const Object* form = limit.get();
      Context context = resolve(*form, parent);
      while (form != nullptr && is_light(*form)) {  // a light counts as what it looks like
        form = form->light()->looks_like.get();
        if (form != nullptr) context = resolve(*form, context);
      }
      if (form == nullptr) continue;
      auto& shared = built[form];
      if (shared == nullptr) shared = solid(*form, context, false);
      out.push_back(shared);
    }
  };
  build_all(extras.clipped_by, result.clips);
  build_all(extras.bounded_by, result.bounds);
  geometry_only_ = outer;
  return result;
}

void SceneBuilder::add_container(const Solid& solid, const Context& own) {
  if (!containers_kept_) return;
  if (const auto* leaf = dynamic_cast<const LeafSolid*>(&solid); leaf != nullptr && leaf->leaf().shape->is_patch()) return;
  built_.containers.add(solid, own.interior);
}

void SceneBuilder::finish() {
  const auto lights = [&](int group) -> auto& { return built_.light_groups[static_cast<std::size_t>(group)].lights; };
  for (const JoinedGroup& joined : joined_groups_) {
    lights(joined.whole) = lights(joined.inner);
    std::ranges::copy(lights(joined.outer), std::back_inserter(lights(joined.whole)));
  }
  built_.tree = std::make_unique<SceneTree>(std::span<const std::unique_ptr<Solid>>(built_.solids));
}

}  // namespace lute
