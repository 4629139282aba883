// `function { pigment {...} }` and `function { pattern {...} }` (specification chapters 10 §11 and 50 §9).
#pragma once

#include "engine/function/function.hpp"
#include "engine/texture/inside_test.hpp"

namespace lute {

class CompiledTextureFunctions final : public TextureFunctions {
 public:
  explicit CompiledTextureFunctions(InsideTestMaker inside_test = nullptr) : inside_test_(std::move(inside_test)) {}

  FunctionPtr pigment_function(const PigmentPtr& pigment, int noise_generator) override;
  FunctionPtr pattern_function(const PatternBody& pattern, int noise_generator) override;

 private:
  InsideTestMaker inside_test_;
};

}  // namespace lute
