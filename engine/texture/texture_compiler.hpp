// Compiles textures once each, however many objects share them, and owns the results.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/texture/compiled_texture.hpp"

namespace lute {

struct TextureSettings {
  int noise_generator = 2;
  int number_of_waves = 10;
  bool quick_colors = false;  // quality 5 and below
  InsideTestMaker inside_test;  // for object patterns; without it nothing is inside
  // Every description was there before the first one is compiled: no two have the same address, even if they go one by one.
  bool addresses_differ = false;
};

class TextureCompiler {
 public:
  explicit TextureCompiler(const TextureSettings& settings);

  // `no_bump_scale`: of a texture around this one, whose entries inherit it.
  const CompiledTexture* texture(const TexturePtr& description, bool no_bump_scale = false);
  const CompiledPigment* pigment(const PigmentPtr& description);
  const CompiledNormal* normal(const NormalPtr& description, bool no_bump_scale);  // null for null

  // Never null.
  std::shared_ptr<const InsideTest> inside_test(const std::shared_ptr<const Object>& object);

  const PatternSettings& pattern_settings() const { return pattern_settings_; }
  bool quick_colors() const { return settings_.quick_colors; }

 private:
  template <class T>
  using Compiled = std::unordered_map<const void*, std::unique_ptr<T>>;

  void keep_address(const std::shared_ptr<const void>& description) {
    if (!settings_.addresses_differ) kept_.push_back(description);
  }

  TextureSettings settings_;
  PatternSettings pattern_settings_;
  Compiled<CompiledTexture> textures_[2];  // without and with an inherited no_bump_scale
  Compiled<CompiledPigment> pigments_;
  std::map<std::pair<const void*, bool>, std::unique_ptr<CompiledNormal>> normals_;
  // Descriptions that compiled forms refer to, and those whose addresses must not be used again.
  std::vector<std::shared_ptr<const void>> kept_;
};

}  // namespace lute
