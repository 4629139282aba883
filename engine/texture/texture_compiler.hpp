// Compiles textures once each, however many objects share them, and owns the results.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "engine/texture/compiled_texture.hpp"

namespace lute {

struct TextureSettings {
  int noise_generator = 2;
  int number_of_waves = 10;
  bool quick_colors = false;  // quality 5 and below
  InsideTestMaker inside_test;  // for object patterns; without it nothing is inside
};

class TextureCompiler {
 public:
  explicit TextureCompiler(const TextureSettings& settings);

  const CompiledTexture* texture(const TexturePtr& description);
  const CompiledPigment* pigment(const PigmentPtr& description);
  const CompiledNormal* normal(const NormalPtr& description, bool no_bump_scale);  // null for null

  // Never null.
  std::shared_ptr<const InsideTest> inside_test(const std::shared_ptr<const Object>& object);

  const PatternSettings& pattern_settings() const { return pattern_settings_; }
  bool quick_colors() const { return settings_.quick_colors; }

 private:
  template <class T>
  using Compiled = std::map<const void*, std::unique_ptr<T>>;

  TextureSettings settings_;
  PatternSettings pattern_settings_;
  Compiled<CompiledTexture> textures_;
  Compiled<CompiledPigment> pigments_;
  std::map<std::pair<const void*, bool>, std::unique_ptr<CompiledNormal>> normals_;
  std::vector<std::shared_ptr<const void>> kept_;  // descriptions whose addresses are keys
};

}  // namespace lute
