// Pigments, normals, finishes, textures: bodies with their pattern, warps and maps.
#include "parser/dump/values.hpp"

namespace lute::dump {
namespace {

const char* name_of(Wave wave) {
  switch (wave) {
    case Wave::kRamp: return "ramp";
    case Wave::kTriangle: return "triangle";
    case Wave::kSine: return "sine";
    case Wave::kScallop: return "scallop";
    case Wave::kCubic: return "cubic";
    case Wave::kPoly: return "poly";
  }
  return "";
}

template <class T>
Json map_json(const BlendMap<T>& map) {
  Json entries = Json::array();
  for (const auto& entry : map.entries) entries.push_back({single(entry.position), to_json(entry.value)});
  return entries;
}

Json body_json(const PatternBody& body) {
  Json json{{"warps", to_json(body.warps)}, {"frequency", single(body.frequency)}, {"phase", single(body.phase)},
            {"wave", name_of(body.wave)}, {"wave_exponent", single(body.wave_exponent)}, {"noise_generator", body.noise_generator}};
  if (std::holds_alternative<NoPattern>(body.pattern)) json["pattern"] = nullptr;
  else if (std::holds_alternative<Average>(body.pattern)) json["pattern"] = {{"name", "average"}};
  else if (std::holds_alternative<UvMapping>(body.pattern)) json["pattern"] = {{"name", "uv_mapping"}};
  else json["pattern"] = to_json(std::get<AnyPattern>(body.pattern));
  return json;
}

Json layers_json(const std::vector<TextureLayer>& layers) {
  Json array = Json::array();
  for (const TextureLayer& layer : layers)
    array.push_back({{"pigment", to_json(layer.pigment)}, {"normal", to_json(layer.normal)}, {"finish", to_json(layer.finish)}});
  return array;
}

}  // namespace

Json to_json(const ColorMap& map) { return map_json(map); }

Json to_json(const PigmentPtr& pigment) {
  if (pigment == nullptr) return nullptr;
  Json json = body_json(pigment->body);
  json["quick_color"] = to_json(pigment->quick_color);
  if (const auto* color = std::get_if<Color>(&pigment->map)) json["color"] = to_json(*color);
  if (const auto* colors = std::get_if<ColorMap>(&pigment->map)) json["color_map"] = map_json(*colors);
  if (const auto* pigments = std::get_if<PigmentMap>(&pigment->map)) json["pigment_map"] = map_json(*pigments);
  return json;
}

Json to_json(const NormalPtr& normal) {
  if (normal == nullptr) return nullptr;
  Json json = body_json(normal->body);
  json["amount"] = single(normal->amount);
  json["accuracy"] = single(normal->accuracy);
  json["no_bump_scale"] = normal->no_bump_scale;
  if (const auto* normals = std::get_if<NormalMap>(&normal->map)) json["normal_map"] = map_json(*normals);
  if (const auto* slopes = std::get_if<SlopeMap>(&normal->map)) {
    Json entries = Json::array();
    for (const auto& entry : slopes->entries) entries.push_back({single(entry.position), entry.value.height, entry.value.slope});
    json["slope_map"] = std::move(entries);
  }
  return json;
}

Json to_json(const FinishPtr& finish) {
  if (finish == nullptr) return nullptr;
  const Finish& f = *finish;
  return {{"ambient", to_json(f.ambient)}, {"emission", to_json(f.emission)}, {"diffuse", single(f.diffuse)},
          {"diffuse_back", single(f.diffuse_back)}, {"raw_diffuse", single(f.raw_diffuse)},
          {"raw_diffuse_back", single(f.raw_diffuse_back)}, {"brilliance", single(f.brilliance)}, {"phong", single(f.phong)},
          {"phong_size", single(f.phong_size)}, {"specular", single(f.specular)}, {"specular_exponent", single(f.specular_exponent)},
          {"metallic", single(f.metallic)}, {"crand", single(f.crand)}, {"conserve_energy", f.conserve_energy},
          {"reflection_min", to_json(f.reflection_min)}, {"reflection_max", to_json(f.reflection_max)},
          {"reflection_falloff", single(f.reflection_falloff)}, {"reflection_exponent", single(f.reflection_exponent)},
          {"reflection_metallic", single(f.reflection_metallic)}, {"reflection_fresnel", f.reflection_fresnel},
          {"irid", single(f.irid)}, {"irid_thickness", single(f.irid_thickness)}, {"irid_turbulence", single(f.irid_turbulence)},
          {"subsurface", f.subsurface}, {"subsurface_translucency", to_json(f.subsurface_translucency)},
          {"subsurface_anisotropy", to_json(f.subsurface_anisotropy)}, {"ior", to_json(f.ior)}, {"caustics", to_json(f.caustics)},
          {"refraction", to_json(f.refraction)}};
}

Json to_json(const TexturePtr& texture) {
  if (texture == nullptr) return nullptr;
  Json json{{"no_bump_scale", texture->no_bump_scale}};
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&texture->content)) {
    json["layers"] = layers_json(*layers);
  } else {
    const auto& patterned = std::get<PatternedTexture>(texture->content);
    json["pattern"] = body_json(patterned.body);
    json["texture_map"] = map_json(patterned.map);
  }
  return json;
}

Json to_json(const TextureOnObject& texture) {
  if (texture.texture == nullptr) return nullptr;
  return {{"texture", to_json(texture.texture)}, {"placement", to_json(texture.placement)}};
}

}  // namespace lute::dump
