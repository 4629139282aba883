// Lights: wherever in the scene they stand they become lights of the scene, or of the light_group they are a direct member of.
// Source: specification chapters 11 §6 and 40 §10.
#include "engine/build/scene_builder.hpp"

namespace lute {

int SceneBuilder::open_light_group(int outer) {
  built_.light_groups.emplace_back();
  outer_groups_.push_back(outer);
  return static_cast<int>(built_.light_groups.size()) - 1;
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
  parent.group_member = false;
  parent.global_lights = true;  // the reference does not hand the wish of a light_group on to it
  return parent;
}

}  // namespace lute
