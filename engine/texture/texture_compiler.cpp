#include "engine/texture/texture_compiler.hpp"

#include <algorithm>

namespace lute {
namespace {

struct NothingInside final : InsideTest {
  bool inside(const dvec3&) const override { return false; }
};

// A map of images is opaque if it is shown everywhere and all its textures are (chapter 40 §11).
bool is_opaque_material_map(const CompiledTexture& texture) {
  const AnyPattern* any = texture.pattern->pattern();
  const auto* map = any != nullptr ? std::get_if<MaterialMap>(any) : nullptr;
  return map != nullptr && !map->mapping.once &&
         std::all_of(texture.entries.begin(), texture.entries.end(), [](const auto& e) { return e.texture->opaque; });
}

}  // namespace

TextureCompiler::TextureCompiler(const TextureSettings& settings) : settings_(settings) {
  pattern_settings_.noise_generator = settings.noise_generator;
  pattern_settings_.waves = std::make_shared<WaveSources>(make_wave_sources(settings.number_of_waves));
}

std::shared_ptr<const InsideTest> TextureCompiler::inside_test(const std::shared_ptr<const Object>& object) {
  if (settings_.inside_test) return settings_.inside_test(object);
  return std::make_shared<NothingInside>();
}

const CompiledPigment* TextureCompiler::pigment(const PigmentPtr& description) {
  if (const auto it = pigments_.find(description.get()); it != pigments_.end()) return it->second.get();
  keep_address(description);
  auto compiled = std::make_unique<CompiledPigment>(*description, *this);
  return (pigments_[description.get()] = std::move(compiled)).get();
}

const CompiledNormal* TextureCompiler::normal(const NormalPtr& description, bool no_bump_scale) {
  if (description == nullptr) return nullptr;
  const auto key = std::pair<const void*, bool>(description.get(), no_bump_scale);
  if (const auto it = normals_.find(key); it != normals_.end()) return it->second.get();
  keep_address(description);
  auto compiled = std::make_unique<CompiledNormal>(*description, no_bump_scale, *this);
  return (normals_[key] = std::move(compiled)).get();
}

const CompiledTexture* TextureCompiler::texture(const TexturePtr& description, bool no_bump_scale) {
  auto& textures = textures_[no_bump_scale ? 1 : 0];
  if (const auto it = textures.find(description.get()); it != textures.end()) return it->second.get();
  keep_address(description);
  auto compiled = std::make_unique<CompiledTexture>();
  no_bump_scale = no_bump_scale || description->no_bump_scale;
  compiled->bump_scale = !no_bump_scale;
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&description->content)) {
    compiled->layers.reserve(layers->size());
    for (const TextureLayer& layer : *layers) {
      if (kept_.empty() || kept_.back() != layer.finish) kept_.push_back(layer.finish);
      compiled->layers.push_back({pigment(layer.pigment), normal(layer.normal, no_bump_scale), layer.finish.get(), layer.finish->reflects()});
      compiled->opaque = compiled->opaque || compiled->layers.back().pigment->is_opaque();
    }
  } else {
    const auto& patterned = std::get<PatternedTexture>(description->content);
    compiled->pattern = std::make_unique<CompiledPattern>(patterned.body, *this);
    for (const auto& entry : patterned.map.entries)
      compiled->entries.push_back({entry.position, texture(entry.value, no_bump_scale)});
    compiled->opaque = is_opaque_material_map(*compiled);
  }
  return (textures[description.get()] = std::move(compiled)).get();
}

}  // namespace lute
