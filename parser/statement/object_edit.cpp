#include "parser/statement/object_edit.hpp"

#include <algorithm>

#include "engine/scene/media.hpp"
#include "parser/statement/interior.hpp"

namespace lute {
namespace {

void transform_light(LightSource& light, const Transform& transform) {
  light.location = transform.point(light.location);
  light.point_at = transform.point(light.point_at);
  if (light.area) {
    light.area->axis1 = transform.direction(light.area->axis1);
    light.area->axis2 = transform.direction(light.area->axis2);
  }
  if (light.looks_like) light.looks_like = transformed(light.looks_like, transform);
  if (light.projected_through) light.projected_through = transformed(light.projected_through, transform);
}

bool holds_media_densities(const Object& object) {
  const InteriorPtr& interior = object.extras->interior;
  if (interior != nullptr && std::ranges::any_of(interior->media, [](const auto& media) { return !media->densities.empty(); }))
    return true;
  return object.csg() != nullptr && object.csg()->contents.media_densities;
}

void move_media(Object& object, const Transform& transform);

ObjectPtr with_moved_media(const ObjectPtr& object, const Transform& transform) {
  if (!holds_media_densities(*object)) return object;
  Object changed = *object;
  move_media(changed, transform);
  return std::make_shared<const Object>(std::move(changed));
}

// Densities live in the world's space: those of the parts move with the whole.
void move_media(Object& object, const Transform& transform) {
  if (!holds_media_densities(object)) return;
  if (object.extras->interior != nullptr) {
    InteriorPtr& interior = object.extras.edit().interior;
    interior = moved(interior, transform);
  }
  if (object.csg() == nullptr) return;
  for (ObjectPtr& child : object.edit_csg()->children) child = with_moved_media(child, transform);
}

void transform_limits(ObjectExtras& extras, const Transform& transform) {
  const bool linked = extras.clipped_by == extras.bounded_by;
  for (ObjectPtr& clip : extras.clipped_by) clip = transformed(clip, transform);
  if (linked) extras.bounded_by = extras.clipped_by;
  else for (ObjectPtr& bound : extras.bounded_by) bound = transformed(bound, transform);
}

// A texture as old as the object has gone through the same transformations, and shares them.
SharedTransform moved_placement(const SharedTransform& placement, const SharedTransform& before, const Object& object,
                                const SharedTransform& transform) {
  return placement.shares(before) ? object.transform : placement.then(transform);
}

}  // namespace

void transform_object(Object& object, const Transform& transform) {
  if (LightSource* light = object.edit_light()) {
    transform_light(*light, transform);
    return;
  }
  const SharedTransform before = object.transform, next = transform;
  object.transform = before.then(next);
  if (!object.uv_mapping) {
    object.texture.placement = moved_placement(object.texture.placement, before, object, next);
    if (object.extras->interior_texture.texture != nullptr) {
      SharedTransform& placement = object.extras.edit().interior_texture.placement;
      placement = moved_placement(placement, before, object, next);
    }
  }
  move_media(object, transform);
  if (!object.extras->clipped_by.empty() || !object.extras->bounded_by.empty()) transform_limits(object.extras.edit(), transform);
}

ObjectPtr transformed(const ObjectPtr& object, const Transform& transform) {
  Object changed = *object;
  transform_object(changed, transform);
  return std::make_shared<const Object>(std::move(changed));
}

bool is_light(const Object& object) { return object.light() != nullptr; }

bool carries_texture(const Object& object) {
  if (object.texture.texture != nullptr) return true;
  return object.csg() != nullptr && object.csg()->contents.textured;
}

std::optional<CsgOperation> effective_operation(const Object& object) {
  const Csg* csg = object.csg();
  if (csg == nullptr) return std::nullopt;
  if (!object.inverse) return csg->operation;
  const bool one_of_all = csg->operation == CsgOperation::kUnion || csg->operation == CsgOperation::kMerge;
  return one_of_all ? CsgOperation::kIntersection : CsgOperation::kMerge;
}

Object absent_object() {
  return {};  // a union of nothing
}

bool is_absent(const Object& object) {
  const Csg* csg = object.csg();
  return csg != nullptr && csg->children.empty();
}

}  // namespace lute
