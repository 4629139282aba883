#include "parser/statement/light.hpp"

#include <string>

#include "parser/statement/blend_map.hpp"
#include "parser/statement/object.hpp"
#include "parser/statement/object_edit.hpp"
#include "parser/statement/object_modifier.hpp"
#include "parser/statement/photons.hpp"
#include "parser/statement/transformation.hpp"

namespace lute {
namespace {

bool is_cone(const LightSource& light) { return light.kind == LightKind::kSpot || light.kind == LightKind::kCylinder; }

void require(Reader& reader, bool allowed, Word keyword) {
  if (!allowed) reader.error("Keyword '" + std::string(spelling(keyword)) + "' cannot be used with standard light source.");
}

void become_spot(LightSource& light) {
  light.kind = LightKind::kSpot;
  light.radius = 30;
  light.falloff = 45;
  light.tightness = 0;
}

void become_cylinder(LightSource& light) {
  light.kind = LightKind::kCylinder;
  light.parallel = true;
  light.radius = 0.75;
  light.falloff = 1;
  light.tightness = 0;
}

bool accept_kind_item(Reader& reader, LightSource& light) {
  if (reader.accept(Word::kShadowless)) {
    light.kind = LightKind::kShadowless;
  } else if (reader.accept(Word::kSpotlight)) {
    become_spot(light);
  } else if (reader.accept(Word::kCylinder)) {
    become_cylinder(light);
  } else if (reader.accept(Word::kParallel)) {
    light.parallel = true;
  } else if (reader.accept(Word::kPointAt)) {
    require(reader, is_cone(light) || light.parallel, Word::kPointAt);
    light.point_at = reader.vector();
  } else if (reader.accept(Word::kRadius)) {
    require(reader, is_cone(light), Word::kRadius);
    light.radius = reader.number();
  } else if (reader.accept(Word::kFalloff)) {
    require(reader, is_cone(light), Word::kFalloff);
    light.falloff = reader.number();
  } else if (reader.accept(Word::kTightness)) {
    require(reader, is_cone(light), Word::kTightness);
    light.tightness = reader.number();
  } else {
    return false;
  }
  return true;
}

// What may be written before area_light is, and then waits for it.
struct AreaItems {
  AreaLight light;
  bool given = false;
};

void parse_area_light(Reader& reader, AreaItems& area) {
  area.given = true;
  area.light.axis1 = reader.vector();
  reader.comma();
  area.light.axis2 = reader.vector();
  reader.comma();
  area.light.size1 = reader.integer();
  reader.comma();
  area.light.size2 = reader.integer();
  if (area.light.size1 <= 0 || area.light.size2 <= 0) reader.error("Area size must be greater than zero.");
}

void require_area(Reader& reader, const AreaItems& area, Word keyword) {
  if (!area.given) reader.warning(std::string(spelling(keyword)) + " area light without area_light.");
}

bool accept_area_item(Reader& reader, AreaItems& area) {
  if (reader.accept(Word::kAreaLight)) {
    parse_area_light(reader, area);
  } else if (reader.accept(Word::kAdaptive)) {
    area.light.adaptive = reader.integer();
  } else if (reader.accept(Word::kJitter)) {
    area.light.jitter = true;
  } else if (reader.accept(Word::kCircular)) {
    require_area(reader, area, Word::kCircular);
    area.light.circular = true;
  } else if (reader.accept(Word::kOrient)) {
    require_area(reader, area, Word::kOrient);
    area.light.orient = true;
  } else if (reader.accept(Word::kAreaIllumination)) {
    area.light.illumination = reader.optional_flag();
  } else {
    return false;
  }
  return true;
}

void settle_area(Reader& reader, AreaItems& area, LightSource& light) {
  constexpr const char* kTooFew = "Circular area light must have more than 1 point per axis";
  if (!area.given) {
    if (area.light.circular) reader.error(kTooFew);
    return;
  }
  if (area.light.orient && !area.light.circular) {
    reader.warning("Orient only works with circular area lights. This area light will become circular.");
    area.light.circular = true;
  }
  if (area.light.circular && (area.light.size1 <= 1 || area.light.size2 <= 1))
    reader.error(kTooFew);
  light.area = area.light;
}

// The object of looks_like or projected_through with its modifiers, `move` applied in front of them.
Object parse_attached_object(Reader& reader, Word keyword, const Transform& move) {
  reader.open(keyword);
  const auto inner = accept_object(reader);
  if (!inner) reader.error_expected("object");
  Object object = **inner;
  transform_object(object, move);
  parse_object_modifiers(reader, object);
  reader.close(keyword);
  return object;
}

void parse_looks_like(Reader& reader, LightSource& light) {
  if (light.looks_like != nullptr) reader.error("Only one looks_like allowed per light_source.");
  Object object = parse_attached_object(reader, Word::kLooksLike, Transform::translate(light.location));
  object.no_shadow = true;
  if (!is_absent(object)) light.looks_like = std::make_shared<const Object>(std::move(object));
}

void parse_projected_through(Reader& reader, LightSource& light) {
  if (light.projected_through != nullptr) reader.error("Only one projected through allowed per light_source.");
  Object object = parse_attached_object(reader, Word::kProjectedThrough, Transform());
  if (object.texture.texture != nullptr || object.extras->interior != nullptr)
    reader.warning("Projected through objects can not have interiors or textures.");
  object.texture = {};
  if (object.extras->interior != nullptr || object.extras->interior_texture.texture != nullptr) {
    object.extras.edit().interior_texture = {};
    object.extras.edit().interior = nullptr;
  }
  if (!is_absent(object)) light.projected_through = std::make_shared<const Object>(std::move(object));
}

void parse_light_photons(Reader& reader, LightSource& light) {
  reader.open(Word::kPhotons);
  while (true) {
    if (reader.accept(Word::kRefraction)) light.photon_refraction = reader.integer() != 0;
    else if (reader.accept(Word::kReflection)) light.photon_reflection = reader.integer() != 0;
    else if (reader.accept(Word::kAreaLight)) light.photon_area_light = true;
    else break;
  }
  reader.close(Word::kPhotons);
}

// The sum of value times colour over the entries becomes the light's colour: undocumented, but read.
Rgb color_of_map(const ColorMap& map) {
  Rgb sum(0.0f);
  for (const auto& entry : map.entries) sum += entry.value.rgb * entry.position;
  return sum;
}

void transform_now(LightSource& light, AreaItems& area, const Transform& transform) {
  Object object;
  light.area = area.light;
  object.geometry = Shared(std::move(light));
  transform_object(object, transform);
  light = std::move(*object.edit_light());
  area.light = *light.area;
  light.area.reset();
}

bool accept_item(Reader& reader, LightSource& light, AreaItems& area) {
  if (accept_kind_item(reader, light) || accept_area_item(reader, area)) return true;
  if (reader.accept(Word::kFadeDistance)) light.fade_distance = reader.number();
  else if (reader.accept(Word::kFadePower)) light.fade_power = reader.number();
  else if (reader.accept(Word::kMediaAttenuation)) light.media_attenuation = reader.optional_flag();
  else if (reader.accept(Word::kMediaInteraction)) light.media_interaction = reader.optional_flag();
  else if (reader.accept(Word::kLooksLike)) parse_looks_like(reader, light);
  else if (reader.accept(Word::kProjectedThrough)) parse_projected_through(reader, light);
  else if (reader.accept(Word::kPhotons)) parse_light_photons(reader, light);
  else if (reader.accept(Word::kColorMap)) light.color = color_of_map(*parse_color_map(reader));
  else if (const auto transform = accept_transformation(reader)) transform_now(light, area, *transform);
  else return false;
  return true;
}

}  // namespace

LightSource parse_light_items(Reader& reader) {
  LightSource light;
  light.location = reader.vector();
  reader.comma();
  light.color = reader.rgb();
  AreaItems area;
  while (accept_item(reader, light, area)) {
  }
  settle_area(reader, area, light);
  return light;
}

void parse_light_group_items(Reader& reader, Object& group) {
  constexpr double kOn = 0.5;
  while (true) {
    if (const auto transform = accept_transformation(reader)) transform_object(group, *transform);
    else if (reader.accept(Word::kGlobalLights)) group.extras.edit().global_lights = reader.optional_number().value_or(1) > kOn;
    else if (reader.accept(Word::kPhotons)) parse_object_photons(reader, group);
    else break;
  }
}

}  // namespace lute
