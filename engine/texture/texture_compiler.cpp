#include "engine/texture/texture_compiler.hpp"

namespace lute {

TextureCompiler::TextureCompiler(const TextureSettings& settings) : settings_(settings) {
  pattern_settings_.noise_generator = settings.noise_generator;
  pattern_settings_.waves = std::make_shared<WaveSources>(make_wave_sources(settings.number_of_waves));
}

const CompiledPigment* TextureCompiler::pigment(const PigmentPtr& description) {
  if (const auto it = pigments_.find(description.get()); it != pigments_.end()) return it->second.get();
  kept_.push_back(description);
  auto compiled = std::make_unique<CompiledPigment>(*description, *this);
  return (pigments_[description.get()] = std::move(compiled)).get();
}

const CompiledNormal* TextureCompiler::normal(const NormalPtr& description, bool no_bump_scale) {
  if (description == nullptr) return nullptr;
  const auto key = std::pair<const void*, bool>(description.get(), no_bump_scale);
  if (const auto it = normals_.find(key); it != normals_.end()) return it->second.get();
  kept_.push_back(description);
  auto compiled = std::make_unique<CompiledNormal>(*description, no_bump_scale, *this);
  return (normals_[key] = std::move(compiled)).get();
}

const CompiledTexture* TextureCompiler::texture(const TexturePtr& description) {
  if (const auto it = textures_.find(description.get()); it != textures_.end()) return it->second.get();
  kept_.push_back(description);
  auto compiled = std::make_unique<CompiledTexture>();
  compiled->bump_scale = !description->no_bump_scale;
  if (const auto* layers = std::get_if<std::vector<TextureLayer>>(&description->content)) {
    for (const TextureLayer& layer : *layers) {
      kept_.push_back(layer.finish);
      compiled->layers.push_back({pigment(layer.pigment), normal(layer.normal, description->no_bump_scale), layer.finish.get()});
      compiled->opaque = compiled->opaque || compiled->layers.back().pigment->is_opaque();
    }
  } else {
    const auto& patterned = std::get<PatternedTexture>(description->content);
    compiled->pattern = std::make_unique<CompiledPattern>(patterned.body, pattern_settings_);
    for (const auto& entry : patterned.map.entries) compiled->entries.push_back({entry.position, texture(entry.value)});
  }
  return (textures_[description.get()] = std::move(compiled)).get();
}

}  // namespace lute
