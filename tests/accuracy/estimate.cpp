// lute-estimate SCENE...: how good the error is that a render with +AM3 estimates. Writes a table for docs/antialiasing.md.
//
// The truth is the mean of two independent Owen-scrambled nets of 1024 samples in each pixel; a regular grid of so many would be off
// where a pattern is in step with it. What noise the nets have left is taken from half of their difference, and subtracted.
// Colours are compared coded, before a file rounds them to 8 bits (which alone is an error of 0.0011).
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "engine/build/geometry_answers.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/render.hpp"
#include "engine/render/scene_view.hpp"
#include "engine/render/sobol_cell.hpp"
#include "engine/texture/texture_functions.hpp"
#include "parser/parse.hpp"

namespace lute {
namespace {

constexpr int kWidth = 120, kHeight = 90, kLevel = 5;
constexpr double kBounds[] = {0.01, 0.003};

struct TruePixel {
  dvec4 coded;
  double noise = 0;  // mean square
};

ParseResult parsed(const std::string& file) {
  GeometryAnswers geometry;
  CompiledTextureFunctions texture_functions(make_inside_test);
  ParseOptions options;
  options.input_file = file;
  options.library_paths = {std::filesystem::path(file).parent_path().string()};
  options.width = kWidth;
  options.height = kHeight;
  options.geometry = &geometry;
  options.texture_functions = &texture_functions;
  ParseResult result = parse_scene(options);
  if (!result.ok) throw std::runtime_error(file + ": not a scene");
  return result;
}

dvec4 net_mean(PixelSource& source, int x, int y, std::uint64_t net, const DisplayMetric& metric) {
  constexpr int kAcross = 1 << kLevel;
  // No seed of the renderer: those have no bits up there.
  const SobolCells points(net << 62 | static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint64_t>(y));
  Color sum;
  for (int i = 0; i < kAcross * kAcross; ++i)
    sum += source.sample(dvec2(x - 0.5, y - 0.5) + points.point(kLevel, i % kAcross, i / kAcross));
  return metric.coded(sum * (1.0f / (kAcross * kAcross)));
}

std::vector<TruePixel> truth(PixelSource& source, const DisplayMetric& metric) {
  std::vector<TruePixel> pixels;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const dvec4 one = net_mean(source, x, y, 1, metric), two = net_mean(source, x, y, 2, metric);
      pixels.push_back({0.5 * (one + two), 0.25 * metric.mean_square(one - two)});
    }
  }
  return pixels;
}

void print_row(const std::string& scene, double bound, const RenderResult& result, const Film& film, const DisplayMetric& metric,
               const std::vector<TruePixel>& truth) {
  double all = 0, seen = 0;
  int unseen = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const TruePixel& pixel = truth[static_cast<std::size_t>(y * kWidth + x)];
      const double square = metric.mean_square(metric.coded(film.at(x, y)) - pixel.coded) - pixel.noise;
      const bool beyond = square > 25 * bound * bound;
      unseen += beyond ? 1 : 0;
      all += square;
      seen += beyond ? 0 : square;
    }
  }
  const auto rmse = [](double sum) { return std::sqrt(std::max(sum, 0.0) / (kWidth * kHeight)); };
  std::printf("| %s | `+AE%g` | %.4f | %.4f | %d | %.4f |\n", scene.c_str(), bound, *result.estimated_error, rmse(all), unseen, rmse(seen));
}

void measure(const std::string& file) {
  ParseResult scene = parsed(file);
  RenderSettings settings;
  settings.area = area_of({}, kWidth, kHeight);
  settings.gamma_mode = scene.scene.settings.gamma_mode;
  settings.assumed_gamma = scene.scene.settings.assumed_gamma;
  settings.antialiasing.method = 3;
  const DisplayMetric metric(settings.gamma_mode, settings.assumed_gamma, false);
  const RenderPlan plan = make_plan(scene.scene);
  const auto built = build_and_release(scene.scene, plan);
  const Tracer tracer(*built, plan);
  const SceneView view(built->camera, *built->textures, tracer, kWidth, kHeight);
  const std::vector<TruePixel> pixels = truth(*view.make_source(), metric);
  for (const double bound : kBounds) {
    settings.antialiasing.error_bound = bound;
    Film film(kWidth, kHeight);
    const RenderResult result = render(
        settings, [&view] { return view.make_source(); }, film);
    print_row(std::filesystem::path(file).filename().string(), bound, result, film, metric, pixels);
  }
}

}  // namespace
}  // namespace lute

int main(int argc, char** argv) {
  try {
    std::puts("120x90 pixels.\n\n| scene | switch | estimate | true error | pixels off by over five bounds | true error of the others |\n"
              "|---|---|---:|---:|---:|---:|");
    for (int i = 1; i < argc; ++i) lute::measure(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lute-estimate: %s\n", error.what());
    return 2;
  }
}
