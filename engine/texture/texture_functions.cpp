#include "engine/texture/texture_functions.hpp"

#include "engine/scene/contents.hpp"
#include "engine/texture/texture_compiler.hpp"

namespace lute {
namespace {

TextureSettings settings_for(int noise_generator, const InsideTestMaker& inside_test) {
  TextureSettings settings;
  settings.noise_generator = noise_generator;
  settings.inside_test = inside_test;
  return settings;
}

// Functions know of no surface.
const SurfaceContext kNoSurface;

class PigmentFunction final : public Function {
 public:
  PigmentFunction(const PigmentPtr& pigment, const TextureSettings& settings)
      : Function(3, 5, pigment->depth + 1), compiler_(settings), pigment_(compiler_.pigment(pigment)) {}

  void evaluate(const double* arguments, double* results) const override {
    Color c;
    pigment_->evaluate({arguments[0], arguments[1], arguments[2]}, kNoSurface, c);
    results[0] = static_cast<double>(c.rgb.r);
    results[1] = static_cast<double>(c.rgb.g);
    results[2] = static_cast<double>(c.rgb.b);
    results[3] = static_cast<double>(c.filter);
    results[4] = static_cast<double>(c.transmit);
  }

 private:
  TextureCompiler compiler_;
  const CompiledPigment* pigment_;
};

class PatternFunction final : public Function {
 public:
  PatternFunction(const PatternBody& body, const TextureSettings& settings)
      : Function(3, 1, depth_of(body) + 1), compiler_(settings), pattern_(body, compiler_) {}

  void evaluate(const double* arguments, double* results) const override {
    results[0] = pattern_.value(pattern_.warp({arguments[0], arguments[1], arguments[2]}), kNoSurface);
  }

 private:
  TextureCompiler compiler_;
  CompiledPattern pattern_;
};

}  // namespace

FunctionPtr CompiledTextureFunctions::pigment_function(const PigmentPtr& pigment, int noise_generator) {
  return std::make_shared<PigmentFunction>(pigment, settings_for(noise_generator, inside_test_));
}

FunctionPtr CompiledTextureFunctions::pattern_function(const PatternBody& pattern, int noise_generator) {
  return std::make_shared<PatternFunction>(pattern, settings_for(noise_generator, inside_test_));
}

}  // namespace lute
