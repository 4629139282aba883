// Objects with their modifiers, lights, interiors, media.
#include "parser/dump/values.hpp"

namespace lute::dump {
namespace {

const char* name_of(CsgOperation operation) {
  switch (operation) {
    case CsgOperation::kUnion: return "union";
    case CsgOperation::kMerge: return "merge";
    case CsgOperation::kIntersection: return "intersection";
    case CsgOperation::kDifference: return "difference";
    case CsgOperation::kLightGroup: return "light_group";
  }
  return "";
}

const char* name_of(LightKind kind) {
  switch (kind) {
    case LightKind::kPoint: return "point";
    case LightKind::kSpot: return "spotlight";
    case LightKind::kCylinder: return "cylinder";
    case LightKind::kShadowless: return "shadowless";
  }
  return "";
}

Json area_json(const AreaLight& a) {
  return {{"axis1", to_json(a.axis1)}, {"axis2", to_json(a.axis2)}, {"size", {a.size1, a.size2}}, {"adaptive", a.adaptive},
          {"jitter", a.jitter}, {"circular", a.circular}, {"orient", a.orient}, {"illumination", a.illumination}};
}

Json geometry_json(const AnyShape& shape) { return to_json(shape); }
Json geometry_json(const Csg& csg) {
  return {{"csg", name_of(csg.operation)}, {"children", list(csg.children)}, {"split_union", csg.split_union},
          {"cutaway_textures", csg.cutaway_textures}};
}
Json geometry_json(const LightSource& l) {
  return {{"light", name_of(l.kind)}, {"parallel", l.parallel}, {"location", to_json(l.location)}, {"point_at", to_json(l.point_at)},
          {"color", to_json(l.color)}, {"radius", l.radius}, {"falloff", l.falloff}, {"tightness", l.tightness},
          {"fade_distance", l.fade_distance}, {"fade_power", l.fade_power}, {"area", l.area ? area_json(*l.area) : Json()},
          {"media_attenuation", l.media_attenuation}, {"media_interaction", l.media_interaction},
          {"looks_like", to_json(l.looks_like)}, {"projected_through", to_json(l.projected_through)},
          {"photon_refraction", to_json(l.photon_refraction)}, {"photon_reflection", to_json(l.photon_reflection)},
          {"photon_area_light", l.photon_area_light}};
}

}  // namespace

Json to_json(const Media& m) {
  return {{"method", m.method}, {"intervals", m.intervals}, {"samples", {m.samples_min, m.samples_max}},
          {"confidence", m.confidence}, {"variance", m.variance}, {"ratio", m.ratio}, {"aa_level", m.aa_level},
          {"aa_threshold", m.aa_threshold}, {"jitter", m.jitter}, {"absorption", to_json(m.absorption)},
          {"emission", to_json(m.emission)}, {"scattering_type", m.scattering_type}, {"scattering", to_json(m.scattering)},
          {"eccentricity", m.eccentricity}, {"extinction", m.extinction}, {"collect", m.collect}, {"densities", list(m.densities)}};
}

Json to_json(const InteriorPtr& interior) {
  if (interior == nullptr) return nullptr;
  Json media = Json::array();
  for (const auto& m : interior->media) media.push_back(to_json(*m));
  return {{"ior", single(interior->ior)}, {"dispersion", single(interior->dispersion)},
          {"dispersion_samples", interior->dispersion_samples}, {"caustics", single(interior->caustics)},
          {"fade_distance", single(interior->fade_distance)}, {"fade_power", single(interior->fade_power)},
          {"fade_color", to_json(interior->fade_color)}, {"refraction", single(interior->refraction)}, {"media", media}};
}

Json to_json(const ObjectPtr& object) {
  if (object == nullptr) return nullptr;
  const Object& o = *object;
  return {{"geometry", std::visit([](const auto& g) { return geometry_json(g); }, o.geometry)},
          {"line", o.where.line},
          {"transform", to_json(o.transform)},
          {"texture", to_json(o.texture)},
          {"interior_texture", to_json(o.extras->interior_texture)},
          {"default_texture", to_json(o.extras->default_texture)},
          {"uv_mapping", bool{o.uv_mapping}},
          {"interior", to_json(o.extras->interior)},
          {"clipped_by", list(o.extras->clipped_by)},
          {"bounded_by", list(o.extras->bounded_by)},
          {"inverse", bool{o.inverse}},
          {"no_shadow", bool{o.no_shadow}},
          {"no_image", bool{o.no_image}},
          {"no_reflection", bool{o.no_reflection}},
          {"no_radiosity", bool{o.no_radiosity}},
          {"double_illuminate", bool{o.double_illuminate}},
          {"hollow", to_json(o.hollow)},
          {"global_lights", to_json(o.extras->global_lights)},
          {"photons",
           {{"target", o.extras->photon_target}, {"density", single(o.extras->photon_density)},
            {"refraction", to_json(o.extras->photon_refraction)}, {"reflection", to_json(o.extras->photon_reflection)},
            {"pass_through", o.extras->photon_pass_through}, {"collect", o.extras->photon_collect}}},
          {"radiosity_importance", to_json(o.extras->radiosity_importance)}};
}

}  // namespace lute::dump
