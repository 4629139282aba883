// Lights: wherever in the scene they stand they become lights of the scene, or of the light_group they are a direct member of.
// Source: specification chapters 11 §6 and 40 §10.
//
// Nested light_groups follow what the reference does, not what its manual says (measured):
//   * an object is lit by the lights of the nearest enclosing group that has any: groups do not add up;
//   * but a shape that is a direct member of a group which was declared, itself or with what it is in, is lit by the lights of the next
//     group outward that has any, too. Text is not a shape here, but a combination of letters;
//   * what a direct member of a group looks like is lit by the next group outward, not by its own;
//   * the outermost group alone says whether global lights count.
#include <algorithm>

#include "engine/build/scene_builder.hpp"

namespace lute {

int SceneBuilder::open_light_group() {
  built_.light_groups.emplace_back();
  return static_cast<int>(built_.light_groups.size()) - 1;
}

void SceneBuilder::enter_light_group(const Object& object, const Csg& group, const Context& parent, Context& own) {
  if (!parent.in_light_group) own.global_lights = object.extras->global_lights.value_or(false);
  own.in_light_group = true;
  own.form_group = parent.light_group;
  const bool has_lights = std::ranges::any_of(group.children, [](const ObjectPtr& child) { return child->light() != nullptr; });
  if (has_lights) own.light_group = open_light_group();
  own.member_group = own.light_group;
  if (has_lights && own.declared && parent.light_group >= 0) {
    own.member_group = open_light_group();
    joined_groups_.push_back({own.member_group, own.light_group, parent.light_group});
  }
}

void SceneBuilder::add_light(const LightSource& light, const Context& own) {
  auto built = std::make_unique<BuiltLight>(build_light(light, own.to_world, options_.quality >= kQualityAreaLights));
  built->fade_distance *= built_.scale;
  if (built->kind == LightKind::kCylinder) {
    built->radius *= built_.scale;
    built->falloff *= built_.scale;
  }
  if (light.projected_through != nullptr) {
    Context parent;
    parent.to_world = own.to_world;
    geometry_only_ = true;  // lights are not built while it is set, so it was not
    built->projected_through = solid(*light.projected_through, resolve(*light.projected_through, parent), false);
    geometry_only_ = false;
  }
  built->number = built_.lights.size();
  if (own.group_member && own.light_group >= 0)
    built_.light_groups[static_cast<std::size_t>(own.light_group)].lights.push_back(built.get());
  else
    built_.global_lights.push_back(built.get());
  built_.lights.push_back(std::move(built));
}

SceneBuilder::Context SceneBuilder::context_for_form(const Context& of_light) {
  Context parent = of_light;
  parent.visibility.no_shadow = true;
  if (of_light.group_member) parent.light_group = of_light.form_group;
  parent.group_member = false;
  parent.global_lights = true;  // the reference does not hand the wish of a light_group on to it
  return parent;
}

}  // namespace lute
