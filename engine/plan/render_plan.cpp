#include "engine/plan/render_plan.hpp"

#include <algorithm>

#include "engine/plan/scene_survey.hpp"

namespace lute {
namespace {

// Collects the items; each answers whether it is needed and why.
class PlanWriter {
 public:
  PlanWriter(RenderPlan& plan, int quality) : plan_(plan), quality_(quality) {}

  void group(std::string name) { group_ = std::move(name); }

  // Needed if `seen`, and the quality is at least `from_quality`.
  bool item(const std::string& name, const Seen& seen, const std::string& because, const std::string& otherwise, int from_quality = 0) {
    if (!seen) return add(name, false, "left out: " + otherwise, {});
    if (quality_ < from_quality)
      return add(name, false, "left out: quality " + std::to_string(quality_) + " is below " + std::to_string(from_quality), seen.where);
    return add(name, true, "needed because " + because + times(seen.count), seen.where);
  }

  bool add(const std::string& name, bool needed, std::string reason, SourceLocation where) {
    plan_.items.push_back({group_, name, needed, std::move(reason), where});
    return needed;
  }

 private:
  static std::string times(long count) { return count > 1 ? " (" + std::to_string(count) + " times)" : ""; }

  RenderPlan& plan_;
  int quality_;
  std::string group_;
};

Seen seen_at(bool there, SourceLocation where) { return {where, there ? 1 : 0}; }

Seen either(const Seen& a, const Seen& b) {
  Seen both = a ? a : b;
  both.count = a.count + b.count;
  return both;
}

void plan_rays(const SceneSurvey& s, PlanWriter& out, RenderPlan& plan) {
  out.group("rays");
  out.add("camera", true, "needed because every picture has a camera", {});
  plan.shadows = out.item("shadow", s.shadow_light, "a light casts shadows", "no light casts shadows", kQualityShadows);
  if (plan.shadows)
    out.item("shadow with colours", s.non_opaque, "a shadow may fall through a surface",
             "every surface is opaque, one query for any blocker is enough");
  plan.transmission = out.item("transmitted", s.translucent, "a surface lets light through", "every surface is opaque", kQualityTransmission);
  if (plan.transmission) {
    out.item("refracted", s.refracting, "an interior has an index of refraction", "every index of refraction is 1", kQualityTransmission);
    out.item("dispersed", s.dispersing, "an interior disperses", "no interior disperses", kQualityTransmission);
  }
  plan.reflection = out.item("reflected", either(s.reflecting, s.conserve_energy), "a finish reflects", "no finish reflects", kQualityReflection);
}

void plan_shading(const SceneSurvey& s, PlanWriter& out, RenderPlan& plan) {
  out.group("shading");
  plan.normals = out.item("normal patterns", s.normal_pattern, "a texture has a normal pattern", "no normal pattern", kQualityReflection);
  const bool phong = out.item("phong", s.phong, "a finish has phong", "no finish has phong", kQualityLights);
  const bool specular = out.item("specular", s.specular, "a finish has specular", "no finish has specular", kQualityLights);
  plan.highlights = phong || specular;
  out.item("iridescence", s.iridescent, "a finish has irid", "no finish has irid", kQualityLights);
  out.item("crand", s.random_diffuse, "a finish has crand", "no finish has crand", kQualityLights);
  out.item("fresnel", s.fresnel, "a reflection follows fresnel", "no reflection follows fresnel", kQualityReflection);
  out.item("layers", s.layered_texture, "a texture has layers", "every texture has one layer");
  out.item("texture maps", s.patterned_texture, "a texture blends textures", "no texture blends textures");
  plan.uv_patterns = out.item("surface coordinates", s.uv_pattern, "uv_mapping asks for them", "no uv_mapping");
  out.item("distance fade", s.fading, "an interior fades light", "no interior fades light", kQualityShadows);
  out.item("faked caustics", s.caustics, "an interior has caustics", "no interior has caustics", kQualityShadows);
}

void plan_lights(const SceneSurvey& s, PlanWriter& out, RenderPlan& plan) {
  out.group("lights");
  plan.lights = out.item("light sources", s.light, "the scene has lights", "the scene has no light", kQualityLights);
  for (const auto& [name, seen] : s.light_kinds)
    out.item(name, seen, "a light_source is one", "none", name.starts_with("area_") ? kQualityAreaLights : kQualityLights);
  out.item("light_group", s.group, "objects have lights of their own", "all lights light all objects", kQualityLights);
  out.item("fade_distance", s.fading_light, "a light fades", "no light fades", kQualityLights);
  out.item("projected_through", s.projecting, "a light shines through an object", "no light is projected", kQualityShadows);
}

void plan_surroundings(const Scene& scene, const SceneSurvey& s, PlanWriter& out, RenderPlan& plan) {
  out.group("surroundings");
  out.item("background", seen_at(scene.background.has_value(), scene.background_where), "the scene has a background",
           "the background is black");
  plan.sky_sphere = out.item("sky_sphere", seen_at(scene.sky_sphere.has_value(), scene.sky_sphere ? scene.sky_sphere->where : SourceLocation{}),
                             "the scene has a sky_sphere", "no sky_sphere");
  Seen fog, rainbow;
  for (const Fog& f : scene.fogs)
    if (has_effect(f)) fog = either(fog, seen_at(true, f.where));
  for (const Rainbow& r : scene.rainbows)
    if (has_effect(r)) rainbow = either(rainbow, seen_at(true, r.where));
  plan.fog = out.item("fog", fog, "the scene has fog", "no fog", kQualityVolumes);
  plan.rainbow = out.item("rainbow", rainbow, "the scene has a rainbow", "no rainbow", kQualityVolumes);
  plan.volume_effects = plan.fog || plan.rainbow;
  plan.interiors = out.item("camera interiors", either(either(s.translucent, s.fading), either(fog, rainbow)),
                            "rays pass surfaces, or something fills space", "no ray passes a surface and nothing fills space");
  if (plan.volume_effects)
    out.add("hollow interiors", true, "needed because fog and rainbow fill only what is hollow", s.hollow.where);
}

void plan_geometry(const SceneSurvey& s, PlanWriter& out) {
  out.group("shapes");
  for (const auto& [name, seen] : s.shapes) out.item(name, seen, "the scene has one", "none");
  out.item("csg", s.csg, "objects are combined", "no objects are combined");
  out.item("clips and bounds", s.clipped, "an object has clipped_by or bounded_by", "none");
  out.group("patterns");
  for (const auto& [name, seen] : s.patterns) out.item(name, seen, "a texture uses it", "none");
}

// The first of these that the scene has.
Seen any_of(const std::map<std::string, Seen>& seen, std::initializer_list<const char*> names) {
  Seen result;
  for (const char* name : names) {
    const auto found = seen.find(name);
    if (found != seen.end()) result = either(result, found->second);
  }
  return result;
}

void plan_acceleration(const SceneSurvey& s, PlanWriter& out) {
  out.group("acceleration");
  Seen solids;
  for (const auto& [name, seen] : s.shapes) solids = either(solids, seen);
  out.item("tree of solids", solids, "rays look for solids in it", "no solids");
  out.item("trees of triangles", any_of(s.shapes, {"mesh", "mesh2"}), "rays look for a mesh's triangles in them", "no mesh");
  out.item("pyramids of heights", any_of(s.shapes, {"height_field"}), "rays look for a height field's hills in them", "no height_field");
}

// Tables that are made when they are first asked for.
void plan_pattern_tables(const Scene& scene, const SceneSurvey& s, PlanWriter& out) {
  out.group("tables");
  out.item("random numbers", any_of(s.patterns, {"cells", "crackle", "facets"}), "a pattern draws from them", "no pattern draws from them");
  Seen patterns;
  for (const auto& [name, seen] : s.patterns) patterns = either(patterns, seen);
  const bool perlin = scene.settings.noise_generator == 3;
  out.item("Perlin's noise", perlin ? patterns : Seen{}, "noise_generator 3 has tables of its own",
           perlin ? "no pattern" : "noise_generator is not 3");
}

std::string place(const Scene& scene, SourceLocation where) {
  if (where.line == 0) return {};
  const std::string file = where.file < scene.files.size() ? scene.files[where.file] : "?";
  return file + ":" + std::to_string(where.line);
}

}  // namespace

RenderPlan make_plan(const Scene& scene, const BuildOptions& options) {
  RenderPlan plan;
  plan.options = options;
  const SceneSurvey survey(scene);
  PlanWriter out(plan, std::clamp(options.quality, 0, 9));
  plan_rays(survey, out, plan);
  plan_shading(survey, out, plan);
  plan_lights(survey, out, plan);
  plan_surroundings(scene, survey, out, plan);
  plan_geometry(survey, out);
  plan_acceleration(survey, out);
  plan_pattern_tables(scene, survey, out);
  out.group("buffers");
  out.add("alpha", options.output_alpha, options.output_alpha ? "needed because the output has alpha" : "left out: the output has no alpha",
          {});
  return plan;
}

std::string RenderPlan::text(const Scene& scene) const {
  std::vector<std::string> groups;
  for (const PlanItem& item : items)
    if (std::ranges::find(groups, item.group) == groups.end()) groups.push_back(item.group);
  std::string result;
  for (const std::string& group : groups) {
    result += group + ":\n";
    for (const PlanItem& item : items) {
      if (item.group != group) continue;
      const std::string where = place(scene, item.where);
      result += "  " + item.name + std::string(item.name.size() < 22 ? 22 - item.name.size() : 1, ' ') + item.reason;
      if (!where.empty()) result += " (" + where + ")";
      result += "\n";
    }
  }
  return result;
}

}  // namespace lute
