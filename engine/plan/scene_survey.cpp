#include "engine/plan/scene_survey.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace lute {
namespace {

void note(Seen& seen, SourceLocation where) {
  if (seen.count++ == 0) seen.where = where;
}

// A texture that an object's pigment, normal or finish began has no statement of its own.
SourceLocation place_of(const Texture& t) {
  if (t.where.line != 0) return t.where;
  const auto* layers = std::get_if<std::vector<TextureLayer>>(&t.content);
  return layers != nullptr && !layers->empty() ? layers->front().pigment->where : t.where;
}

bool lets_through(const Color& c) { return c.filter != 0 || c.transmit != 0; }

}  // namespace

bool certainly_opaque(const Pigment& p) {
  if (const auto* plain = std::get_if<Color>(&p.map)) return !lets_through(*plain);
  if (const auto* colors = std::get_if<ColorMap>(&p.map))
    return std::ranges::none_of(colors->entries, [](const auto& e) { return lets_through(e.value); });
  if (const auto* pigments = std::get_if<PigmentMap>(&p.map))
    return std::ranges::all_of(pigments->entries, [](const auto& e) { return certainly_opaque(*e.value); });
  if (std::holds_alternative<NoPattern>(p.body.pattern)) return true;
  if (const auto* any = std::get_if<AnyPattern>(&p.body.pattern))
    if (const auto* image = std::get_if<ImageMap>(any)) return is_opaque(*image);
  const auto& entries = default_color_map(p.body).entries;
  return std::ranges::none_of(entries, [](const auto& e) { return lets_through(e.value); });
}

bool certainly_opaque(const Texture& t) {
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&t.content))
    return std::ranges::any_of(*layers, [](const TextureLayer& l) { return certainly_opaque(*l.pigment); });
  const auto& patterned = std::get<PatternedTexture>(t.content);
  return std::ranges::all_of(patterned.map.entries, [](const auto& e) { return certainly_opaque(*e.value); });
}

bool has_effect(const Fog& fog) { return std::abs(fog.distance) > kEpsilon; }

bool has_effect(const Rainbow& r) { return !r.colors.entries.empty() && r.width != 0 && r.distance != 0; }

SceneSurvey::SceneSurvey(const Scene& scene) {
  for (const ObjectPtr& o : scene.objects) {
    object(*o);
    if (o->extras->default_texture != nullptr) texture(*o->extras->default_texture);
  }
  if (scene.sky_sphere)
    for (const PigmentPtr& p : scene.sky_sphere->pigments) pigment(*p);
}

void SceneSurvey::object(const Object& o) {
  if (o.texture.texture) texture(*o.texture.texture);
  if (o.extras->interior_texture.texture) texture(*o.extras->interior_texture.texture);
  if (o.extras->interior) interior(*o.extras->interior);
  if (o.hollow.value_or(false)) note(hollow, o.where);
  if (o.uv_mapping) note(uv_pattern, o.where);
  if (!o.extras->clipped_by.empty() || !o.extras->bounded_by.empty()) note(clipped, o.where);
  if (const LightSource* l = o.light()) {
    light_source(*l);
  } else if (const Csg* c = o.csg()) {
    const bool is_group = c->operation == CsgOperation::kLightGroup;
    note(is_group ? group : csg, o.where);
    // Where textures come from the solids around a cut, the surface may be anything.
    if (c->cutaway_textures) note(non_opaque, o.where);
    for (const ObjectPtr& child : c->children) object(*child);
  } else {
    o.shape()->visit(
        [&](const auto& s) {
          using Description = std::decay_t<decltype(s)>;
          note(shapes[std::string(Description::kKeyword)], o.where);
          if constexpr (std::is_same_v<Description, Mesh>) {
            for (const TexturePtr& t : s.data->textures) texture(*t);
          } else if constexpr (std::is_same_v<Description, Blob>) {
            for (const auto& part : s.components)
              if (part.texture) texture(*part.texture);
          }
        });
  }
}

void SceneSurvey::light_source(const LightSource& l) {
  if (l.looks_like) object(*l.looks_like);
  note(light, l.where);
  const bool shadowless = l.kind == LightKind::kShadowless;
  if (!shadowless || l.projected_through) note(shadow_light, l.where);
  if (l.projected_through) note(projecting, l.where);
  if (l.fade_power > 0 && l.fade_distance != 0) note(fading_light, l.where);
  if (l.media_attenuation && l.media_interaction) note(fog_light, l.where);
  switch (l.kind) {
    case LightKind::kPoint: note(light_kinds["point"], l.where); break;
    case LightKind::kSpot: note(light_kinds["spotlight"], l.where); break;
    case LightKind::kCylinder: note(light_kinds["cylinder"], l.where); break;
    case LightKind::kShadowless: note(light_kinds["shadowless"], l.where); break;
  }
  if (l.parallel) note(light_kinds["parallel"], l.where);
  if (l.area) note(light_kinds[l.area->illumination ? "area_illumination" : "area_light"], l.where);
}

void SceneSurvey::interior(const Interior& i) {
  if (!first_visit(&i)) return;
  if (i.ior != 0 && i.ior != 1) note(refracting, i.where);
  if (i.ior != 0 && i.dispersion != 1) note(dispersing, i.where);
  if (i.fade_distance != 0) note(fading, i.where);
  if (i.caustics != 0) note(caustics, i.where);
  if (!i.media.empty()) note(object_media, i.where);
}

void SceneSurvey::texture(const Texture& t) {
  if (!first_visit(&t)) return;
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&t.content)) {
    if (layers->size() > 1) note(layered_texture, place_of(t));
    // Light passes a texture where it passes all of its layers.
    if (std::ranges::none_of(*layers, [](const TextureLayer& l) { return certainly_opaque(*l.pigment); })) {
      note(translucent, place_of(t));
      note(non_opaque, place_of(t));
    }
    for (const TextureLayer& l : *layers) layer(l, place_of(t));
    return;
  }
  const auto& patterned = std::get<PatternedTexture>(t.content);
  note(patterned_texture, t.where);
  note(non_opaque, t.where);
  body(patterned.body, t.where);
  for (const auto& entry : patterned.map.entries) texture(*entry.value);
}

void SceneSurvey::layer(const TextureLayer& l, SourceLocation where) {
  pigment(*l.pigment);
  if (l.normal) normal(*l.normal);
  finish(*l.finish, l.pigment->where.line != 0 ? l.pigment->where : where);
}

void SceneSurvey::finish(const Finish& f, SourceLocation where) {
  if (f.reflects()) {
    note(reflecting, where);
    if (f.reflection_fresnel) note(fresnel, where);
  }
  if (f.conserve_energy) note(conserve_energy, where);
  if (f.phong > 0) note(phong, where);
  if (f.specular > 0) note(specular, where);
  if (f.irid > 0) note(iridescent, where);
  if (f.crand > 0) note(random_diffuse, where);
  if (f.subsurface) note(subsurface, where);
  if (f.ior && *f.ior != 0 && *f.ior != 1) note(refracting, where);
  if (f.caustics && *f.caustics != 0) note(caustics, where);
}

void SceneSurvey::body(const PatternBody& b, SourceLocation where) {
  if (std::holds_alternative<UvMapping>(b.pattern)) note(uv_pattern, where);
  if (std::holds_alternative<Average>(b.pattern)) note(patterns["average"], where);
  if (const auto* pattern = std::get_if<AnyPattern>(&b.pattern))
    std::visit([&](const auto& p) { note(patterns[std::string(std::decay_t<decltype(p)>::kKeyword)], where); }, *pattern);
}

void SceneSurvey::pigment(const Pigment& p) {
  if (!first_visit(&p)) return;
  body(p.body, p.where);
  if (const auto* map = std::get_if<PigmentMap>(&p.map))
    for (const auto& entry : map->entries) pigment(*entry.value);
}

void SceneSurvey::normal(const Normal& n) {
  if (!first_visit(&n)) return;
  note(normal_pattern, n.where);
  body(n.body, n.where);
  if (const auto* map = std::get_if<NormalMap>(&n.map))
    for (const auto& entry : map->entries)
      if (entry.value) normal(*entry.value);
}

}  // namespace lute
