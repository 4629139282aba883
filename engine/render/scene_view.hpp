// A built scene seen through its camera: what the renderer asks for the colour of an image position.
#pragma once

#include <memory>
#include <optional>

#include "engine/camera/focal_blur.hpp"
#include "engine/camera/projection.hpp"
#include "engine/render/pixel_source.hpp"
#include "engine/shade/tracer.hpp"

namespace lute {

class SceneView {
 public:
  // Compiles the camera's own textures (`normal`, `bokeh`) into `textures`. `tracer` must outlive the view.
  SceneView(const Camera& camera, TextureCompiler& textures, const Tracer& tracer, int width, int height);

  // For one thread; lives no longer than the view.
  std::unique_ptr<PixelSource> make_source() const;

 private:
  class Source;

  // The unnormalised ray with the camera's `normal` applied; false: none at this position.
  bool project(dvec2 position, ProjectedRay& ray, int index = 0) const;

  Projection projection_;
  std::optional<FocalBlur> blur_;
  const CompiledNormal* normal_;  // null: none
  const Tracer& tracer_;
};

}  // namespace lute
