// A normal pattern ready to perturb normals (specification chapter 50 §13).
#pragma once

#include <memory>
#include <vector>

#include "engine/texture/blend.hpp"
#include "engine/texture/compiled_pattern.hpp"

namespace lute {

class TextureCompiler;

class CompiledNormal {
 public:
  CompiledNormal(const Normal& normal, bool no_bump_scale, TextureCompiler& compiler);

  // The perturbed normal, unit, in the space of `point`. It is not turned toward the ray.
  dvec3 perturb(const dvec3& normal, const dvec3& point, const SurfaceContext& surface) const;

  // The same, of any length without bump scale: so are normals of a map blended, and seen by patterns.
  dvec3 bend(const dvec3& normal, const dvec3& point, const SurfaceContext& surface) const;

  // False: no_bump_scale, here or on the texture.
  bool bump_scale() const { return bump_scale_; }

  // True: it bends the normal as the world has it, whatever moved the texture (chapter 50 §10.5).
  bool is_uv_mapping() const { return pattern_->is_uv_mapping() && !normals_.empty(); }

 private:
  struct NormalEntry {
    float position;
    const CompiledNormal* normal;
  };

  dvec3 by_slope(dvec3 normal, const dvec3& warped, const SurfaceContext& surface) const;
  dvec3 by_map(const dvec3& normal, const dvec3& warped, const SurfaceContext& surface) const;

  std::unique_ptr<CompiledPattern> pattern_;
  double amount_, accuracy_;
  bool bump_scale_;
  std::vector<NormalEntry> normals_;
  std::vector<SlopeMap::Entry> slopes_;
};

}  // namespace lute
