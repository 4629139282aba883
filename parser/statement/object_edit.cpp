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
  if (object.interior != nullptr &&
      std::ranges::any_of(object.interior->media, [](const auto& media) { return !media->densities.empty(); }))
    return true;
  const auto* csg = std::get_if<Csg>(&object.geometry);
  return csg != nullptr && std::ranges::any_of(csg->children, [](const ObjectPtr& child) { return holds_media_densities(*child); });
}

// Densities live in the world's space: those of the parts move with the whole.
ObjectPtr with_moved_media(const ObjectPtr& object, const Transform& transform) {
  if (!holds_media_densities(*object)) return object;
  Object changed = *object;
  changed.interior = moved(changed.interior, transform);
  if (auto* csg = std::get_if<Csg>(&changed.geometry))
    for (ObjectPtr& child : csg->children) child = with_moved_media(child, transform);
  return std::make_shared<const Object>(std::move(changed));
}

}  // namespace

void transform_object(Object& object, const Transform& transform) {
  if (auto* light = std::get_if<LightSource>(&object.geometry)) {
    transform_light(*light, transform);
    return;
  }
  object.transform = object.transform.then(transform);
  if (!object.uv_mapping) {
    object.texture.placement = object.texture.placement.then(transform);
    object.interior_texture.placement = object.interior_texture.placement.then(transform);
  }
  object.interior = moved(object.interior, transform);
  const bool linked = object.clipped_by == object.bounded_by;
  for (ObjectPtr& clip : object.clipped_by) clip = transformed(clip, transform);
  if (linked) object.bounded_by = object.clipped_by;
  else for (ObjectPtr& bound : object.bounded_by) bound = transformed(bound, transform);
  if (auto* csg = std::get_if<Csg>(&object.geometry))
    for (ObjectPtr& child : csg->children) child = with_moved_media(child, transform);
}

ObjectPtr transformed(const ObjectPtr& object, const Transform& transform) {
  Object changed = *object;
  transform_object(changed, transform);
  return std::make_shared<const Object>(std::move(changed));
}

bool is_patch(const Object& object) {
  const auto* shape = std::get_if<AnyShape>(&object.geometry);
  if (shape == nullptr) return false;
  return std::visit(
      [](const auto& s) {
        if constexpr (requires { s.inside_vector; }) return s.inside_vector == dvec3(0);
        constexpr std::string_view keyword = std::decay_t<decltype(s)>::kKeyword;
        return keyword == "triangle" || keyword == "smooth_triangle" || keyword == "bicubic_patch" || keyword == "polygon" ||
               keyword == "parametric";
      },
      *shape);
}

bool is_light(const Object& object) { return std::holds_alternative<LightSource>(object.geometry); }

bool carries_texture(const Object& object) {
  if (object.texture.texture != nullptr) return true;
  const auto* csg = std::get_if<Csg>(&object.geometry);
  return csg != nullptr && std::ranges::any_of(csg->children, [](const ObjectPtr& child) { return carries_texture(*child); });
}

std::optional<CsgOperation> effective_operation(const Object& object) {
  const auto* csg = std::get_if<Csg>(&object.geometry);
  if (csg == nullptr) return std::nullopt;
  if (!object.inverse) return csg->operation;
  const bool one_of_all = csg->operation == CsgOperation::kUnion || csg->operation == CsgOperation::kMerge;
  return one_of_all ? CsgOperation::kIntersection : CsgOperation::kMerge;
}

Object absent_object() {
  Object object;
  object.geometry = Csg{};
  return object;
}

bool is_absent(const Object& object) {
  const auto* csg = std::get_if<Csg>(&object.geometry);
  return csg != nullptr && csg->children.empty();
}

}  // namespace lute
