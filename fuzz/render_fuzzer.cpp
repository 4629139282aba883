// libFuzzer target: a scene that the parser accepts is built and rendered, few pixels with few levels: shapes, textures and lights
// with whatever numbers the text gave them.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/build/built_scene.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/render.hpp"
#include "engine/render/scene_view.hpp"
#include "engine/shade/tracer.hpp"
#include "fuzz/read_scene.hpp"

namespace {

constexpr int kWidth = 6, kHeight = 4;
constexpr int kLevels = 4;

void render_scene(lute::Scene& scene) {
  scene.settings.max_trace_level = std::min(scene.settings.max_trace_level, kLevels);
  const lute::RenderPlan plan = lute::make_plan(scene, {});
  const auto built = lute::build_scene(scene, plan);
  const lute::Tracer tracer(*built, plan);
  const lute::SceneView view(built->camera, *built->textures, tracer, kWidth, kHeight);
  lute::Film film(kWidth, kHeight);
  lute::RenderSettings settings;
  settings.area = {0, 0, kWidth - 1, kHeight - 1};
  lute::render(settings, [&view] { return view.make_source(); }, film);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lute::ParseResult parsed = read_scene(std::string(reinterpret_cast<const char*>(data), size));
  if (parsed.ok) render_scene(parsed.scene);
  return 0;
}
