#include "app/frame_job.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "engine/build/geometry_answers.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/write_image.hpp"
#include "engine/plan/render_plan.hpp"
#include "engine/render/render.hpp"
#include "engine/render/scene_view.hpp"
#include "engine/shape/gradient_remark.hpp"
#include "engine/texture/texture_functions.hpp"

namespace lute {
namespace {

int thread_count(const RenderOptions& options) {
  if (options.threads > 0) return options.threads;
  const unsigned processors = std::thread::hardware_concurrency();
  return processors == 0 ? 1 : static_cast<int>(processors);
}

RenderSettings render_settings(const RenderOptions& options, const Scene& scene) {
  RenderSettings settings;
  settings.area = area_of(options.partial, options.width, options.height);
  settings.block_size = options.block_size;
  settings.threads = thread_count(options);
  settings.antialiasing = options.antialiasing;
  settings.gamma_mode = scene.settings.gamma_mode;
  settings.assumed_gamma = scene.settings.assumed_gamma;
  settings.alpha = options.output.alpha;
  settings.estimate_error = options.statistics;
  return settings;
}

bool rendered_before(const std::string& path) {
  std::error_code ignored;
  return path != "-" && std::filesystem::is_regular_file(path, ignored) &&
         std::filesystem::file_size(path, ignored) > 0;
}

std::string summary(const RenderOptions& options, const std::string& path, const StageTimes& times,
                    const RenderResult& result) {
  std::array<char, 120> text;
  std::snprintf(text.data(), text.size(), ": %d x %d pixels, parse %.2f s, build %.2f s, render %.2f s", options.width,
                options.height, times.parse, times.build, times.render);
  std::string line = (path == "-" ? "standard output" : path) + text.data();
  if (!result.estimated_error) return line;
  std::snprintf(text.data(), text.size(), ", estimated error %.5f", *result.estimated_error);
  return line + text.data();
}

// What isosurfaces have to say about max_gradient once they have seen all rays: of those that one statement makes, in a loop, the one
// that was farthest from enough.
void remark_on_gradients(const BuiltScene& built, const Scene& scene, Console& console) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::pair<SourceLocation, GradientRemark>> at_place;
  for (const auto& [shape, where] : built.isosurfaces) {
    const GradientRemark remark = gradient_remark(*shape);
    auto& entry = at_place[{where.file, where.line, where.column}];
    if (remark.ratio() > entry.second.ratio()) entry = {where, remark};
  }
  for (const auto& [key, entry] : at_place) {
    const auto& [where, remark] = entry;
    Diagnostic warning;
    warning.message = remark.text();
    if (warning.message.empty()) continue;
    warning.severity = Severity::kWarning;
    warning.code = "max-gradient";
    warning.file = where.file < scene.files.size() ? scene.files[where.file] : "";
    warning.where = where;
    warning.end_column = where.column;
    console.diagnostic(warning);
  }
}

}  // namespace

BuildOptions build_options(const RenderOptions& options) {
  BuildOptions build;
  build.quality = options.quality;
  build.output_alpha = options.output.alpha;
  build.bounding_threshold = options.bounding_threshold;
  build.remove_bounds = options.remove_bounds;
  build.split_unions = options.split_unions;
  return build;
}

ParseResult parse_frame(const RenderOptions& options, const Frame& frame, const std::optional<std::string>& text,
                        Console& console) {
  GeometryAnswers geometry;
  CompiledTextureFunctions texture_functions(make_inside_test);
  ParseOptions parse;
  parse.input_file = options.input_file;
  parse.input_text = text;
  parse.library_paths = options.library_paths;
  parse.declares = options.declares;
  parse.clock = frame.clock;
  parse.clock_on = frame.clock_on;
  parse.frame = frame.values;
  parse.width = options.width;
  parse.height = options.height;
  parse.version = options.version;
  parse.include_header = options.include_header;
  parse.limits = options.limits;
  parse.allow_read = options.allow_read;
  parse.allow_write = options.allow_write;
  if (options.output_to_file) {
    const std::string folder = std::filesystem::path(output_path(options, frame)).parent_path().string();
    parse.allow_read.push_back(folder);
    parse.allow_write.push_back(folder);
  }
  parse.geometry = &geometry;
  parse.texture_functions = &texture_functions;
  parse.on_diagnostic = [&console](const Diagnostic& diagnostic) { console.diagnostic(diagnostic); };
  parse.on_debug = [&console](std::string_view line) { console.debug(line); };
  return parse_scene(parse);
}

ExitCode render_frame(const RenderOptions& options, const Frame& frame, const std::optional<std::string>& text,
                      Console& console) {
  const std::string path = output_path(options, frame);
  if (options.output_to_file) {
    if (options.continue_trace && rendered_before(path)) {
      console.line(path + " is rendered already");
      return ExitCode::kDone;
    }
    check_writable(path);
  }
  StageTimes times;
  Stopwatch parse_watch;
  ParseResult parsed = parse_frame(options, frame, text, console);
  times.parse = parse_watch.seconds();
  if (!parsed.ok) return ExitCode::kFailed;

  Stopwatch build_watch;
  const RenderPlan plan = make_plan(parsed.scene, build_options(options));
  const std::unique_ptr<BuiltScene> built = build_and_release(parsed.scene, plan);
  const Tracer tracer(*built, plan);
  const SceneView view(built->camera, *built->textures, tracer, options.width, options.height);
  times.build = build_watch.seconds();

  Stopwatch render_watch;
  const RenderSettings settings = render_settings(options, parsed.scene);
  Film film(options.width, options.height);
  RenderResult result;
  {
    Progress progress(options.input_file, options.verbose);
    result = render(settings, [&view] { return view.make_source(); }, film,
                    {[&progress](long done, long total) { progress.update(done, total); }});
  }
  times.render = render_watch.seconds();

  const Interrupt::Guard guard;
  Stopwatch write_watch;
  if (options.output_to_file) {
    write_image(path, film, {settings.gamma_mode, settings.assumed_gamma}, options.output);
  }
  times.write = write_watch.seconds();
  remark_on_gradients(*built, parsed.scene, console);
  console.line(summary(options, options.output_to_file ? path : "no file", times, result));
  if (options.statistics) std::fputs(statistics_text(result, times, settings.area.pixels()).c_str(), stderr);
  return Interrupt::flag() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace lute
