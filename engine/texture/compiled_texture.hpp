// A texture ready to be shaded: layers, or a pattern over further textures (specification chapters 40 §4.1 and 50 §12).
#pragma once

#include <memory>
#include <vector>

#include "engine/scene/finish.hpp"
#include "engine/texture/compiled_normal.hpp"
#include "engine/texture/compiled_pigment.hpp"

namespace lute {

struct CompiledLayer {
  const CompiledPigment* pigment = nullptr;
  const CompiledNormal* normal = nullptr;  // null: none
  const Finish* finish = nullptr;
  bool reflects = false;  // what finish->reflects() says
};

struct CompiledTexture {
  struct Entry {
    float position = 0;
    const CompiledTexture* texture = nullptr;
  };

  // From the bottom (first written) to the top; empty where `pattern` decides.
  std::vector<CompiledLayer> layers;
  std::unique_ptr<CompiledPattern> pattern;
  std::vector<Entry> entries;
  bool bump_scale = true;

  // Some layer is a plain pigment through which no light passes: a shadow ray ends here (chapter 40 §11).
  bool opaque = false;
};

}  // namespace lute
