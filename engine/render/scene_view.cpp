#include "engine/render/scene_view.hpp"

#include <bit>
#include <limits>

namespace lute {

class SceneView::Source final : public PixelSource {
 public:
  explicit Source(const SceneView& view) : view_(view) {
    project_ = [this](dvec2 at, ProjectedRay& ray) { return view_.project(at, ray); };
    trace_ = [this](const Ray& ray) { return trace(ray, std::numeric_limits<double>::infinity()); };
  }

  Color sample(dvec2 position) override {
    // Random numbers depend on the position alone, so that a pixel is the same in whatever block it is traced.
    context_.start_sample(std::bit_cast<std::uint64_t>(position.x), std::bit_cast<std::uint64_t>(position.y));
    if (view_.blur_) return view_.blur_->sample(position, project_, trace_);
    return view_.projection_.rays_per_position() == 1 ? color_of_ray(position) : mean_of_rays(position);
  }

  Counters counters() const override { return context_.counters; }

 private:
  Color color_of_ray(dvec2 position) {
    ProjectedRay ray;
    if (!view_.project(position, ray)) return {Rgb(0.0f), 0, 1};
    return trace({ray.origin, glm::normalize(ray.direction)}, ray.reach);
  }

  // Rays that the camera does not have are left out.
  Color mean_of_rays(dvec2 position) {
    Color sum;
    int traced = 0;
    for (int index = 0; index < view_.projection_.rays_per_position(); ++index) {
      ProjectedRay ray;
      if (!view_.project(position, ray, index)) continue;
      sum += trace({ray.origin, glm::normalize(ray.direction)}, ray.reach);
      ++traced;
    }
    if (traced == 0) return {Rgb(0.0f), 0, 1};
    return traced == 1 ? sum : sum * (1.0f / static_cast<float>(traced));
  }

  Color trace(const Ray& ray, double reach) {
    // Most cameras have one origin: what contains it is asked once.
    if (ray.origin != known_origin_) {
      context_.camera_interiors = view_.tracer_.interiors_at(ray.origin);
      known_origin_ = ray.origin;
    }
    return view_.tracer_.trace(ray, context_, reach);
  }

  const SceneView& view_;
  TraceContext context_;
  dvec3 known_origin_{std::numeric_limits<double>::quiet_NaN()};
  FocalBlur::ProjectRay project_;
  FocalBlur::TraceRay trace_;
};

namespace {

std::optional<FocalBlur> make_blur(const Camera& camera, TextureCompiler& textures) {
  if (!FocalBlur::wanted(camera)) return std::nullopt;
  if (!camera.bokeh) return FocalBlur(camera);
  const CompiledPigment* pigment = textures.pigment(camera.bokeh);
  return FocalBlur(camera, [pigment](dvec2 p) {
    Color color;
    pigment->evaluate({p.x + 0.5, p.y + 0.5, 0}, SurfaceContext{}, color);
    return static_cast<double>(grey(color.rgb));
  });
}

}  // namespace

SceneView::SceneView(const Camera& camera, TextureCompiler& textures, const Tracer& tracer, int width, int height)
    : projection_(camera, width, height),
      blur_(make_blur(camera, textures)),
      normal_(textures.normal(camera.normal, false)),
      tracer_(tracer) {}

bool SceneView::project(dvec2 position, ProjectedRay& ray, int index) const {
  if (!projection_.project(position, ray, index)) return false;
  if (normal_ != nullptr) {
    const double length = glm::length(ray.direction);
    SurfaceContext surface;
    surface.raw_normal = surface.normal = ray.direction / length;
    ray.direction = length * normal_->perturb(surface.normal, {ray.pattern_point, 0}, surface);
  }
  return true;
}

std::unique_ptr<PixelSource> SceneView::make_source() const { return std::make_unique<Source>(*this); }

}  // namespace lute
