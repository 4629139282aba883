// A pigment ready to be evaluated (specification chapter 50 §10-11).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/texture/blend.hpp"
#include "engine/texture/compiled_pattern.hpp"

namespace lute {

class TextureCompiler;

class CompiledPigment {
 public:
  CompiledPigment(const Pigment& pigment, TextureCompiler& compiler);

  // The colour at a point of the texture's space. False: no colour here (the pigment is an image shown once, and the point lies
  // outside); `color` is then clear.
  bool evaluate(const dvec3& point, const SurfaceContext& surface, Color& color) const {
    if (kind_ != Kind::kConstant) return evaluate_pattern(point, surface, color);
    color = constant_;
    return true;
  }

  bool is_constant() const { return kind_ == Kind::kConstant; }
  bool is_opaque() const { return opaque_; }  // no colour of it has filter or transmit

 private:
  enum class Kind : std::uint8_t { kConstant, kColors, kPigments, kAverage, kUv, kImage };
  struct PigmentEntry {
    float position;
    const CompiledPigment* pigment;
  };

  void take_pigments(const PigmentMap& map, TextureCompiler& compiler);
  bool evaluate_pattern(const dvec3& point, const SurfaceContext& surface, Color& color) const;
  void look_up(double value, Color& color) const;
  void blend(const dvec3& warped, const SurfaceContext& surface, Color& color) const;
  void average(const dvec3& warped, const SurfaceContext& surface, Color& color) const;

  Kind kind_ = Kind::kConstant;
  Color constant_;
  std::vector<ColorMap::Entry> colors_;
  std::vector<PigmentEntry> pigments_;
  std::unique_ptr<CompiledPattern> pattern_;  // null for constants
  const ImageMap* image_ = nullptr;           // of an image
  bool opaque_ = true;
};

}  // namespace lute
