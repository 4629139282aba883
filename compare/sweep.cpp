#include "compare/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "compare/content_hash.hpp"
#include "compare/curve_name.hpp"
#include "compare/figures.hpp"
#include "compare/scratch_folder.hpp"
#include "compare/sweep_summary.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

constexpr int kSamplesAcross = 16;

// The mean of each square of samples in linear light, coded as sRGB.
Picture reduced(const Picture& large, int width, int height) {
  Picture small(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sums[Picture::kChannels] = {};
      for (int i = 0; i < kSamplesAcross * kSamplesAcross; ++i) {
        const float* sample =
            large.at(x * kSamplesAcross + i % kSamplesAcross, y * kSamplesAcross + i / kSamplesAcross);
        for (int c = 0; c < Picture::kChannels; ++c) sums[c] += sample[c];
      }
      constexpr double kCount = kSamplesAcross * kSamplesAcross;
      for (int c = 0; c < 3; ++c) small.at(x, y)[c] = static_cast<float>(srgb_encoded(sums[c] / kCount));
      small.at(x, y)[3] = static_cast<float>(sums[3] / kCount);
    }
  }
  return small;
}

// ": " and the last line that says something.
std::string last_line(const std::string& messages) {
  std::istringstream lines(messages);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  }
  return last.empty() ? "" : ": " + last;
}

// Renders one point once and adds the times.
void run_point(SweepPoint& point, const std::string& program, const SceneFile& scene, const SweepSettings& settings,
               std::vector<double>& cpu, std::vector<double>& wall) {
  RenderSettings render_settings;
  render_settings.width = settings.width;
  render_settings.height = settings.height;
  render_settings.switches = words_of(point.setting);
  render_settings.switches.push_back("+WT1");
  render_settings.time_limit = settings.time_limit;
  const RenderRun run = render(program, scene.path, point.picture, render_settings);
  point.rendered = run.outcome == RenderOutcome::kRendered;
  if (!point.rendered) point.failure = std::string(name_of(run.outcome)) + last_line(run.messages);
  cpu.push_back(run.process.cpu);
  wall.push_back(run.process.wall);
}

void measure_error(SweepPoint& point, const Picture& converged) {
  const Picture picture = read_picture(point.picture);
  const Difference d = difference(picture, converged);
  point.rmse = d.rmse;
  point.within = d.within;
  point.heat_map = fs::path(point.picture).replace_extension(".heat.png");
  write_picture(heat_map(picture, converged), point.heat_map);
}

}  // namespace

void mark_pareto_front(std::vector<SweepPoint>& points) {
  for (SweepPoint& point : points) {
    point.pareto = point.rendered && std::none_of(points.begin(), points.end(), [&](const SweepPoint& other) {
                     const bool no_worse = other.rendered && other.cpu <= point.cpu && other.rmse <= point.rmse;
                     return no_worse && (other.cpu < point.cpu || other.rmse < point.rmse);
                   });
  }
}

Picture converged_picture(const SceneFile& scene, const SweepSettings& settings, const fs::path& cache_folder) {
  RenderSettings large;
  large.width = settings.width * kSamplesAcross;
  large.height = settings.height * kSamplesAcross;
  large.file_type = "E";
  large.time_limit = 0;
  const std::string key = scene_hash(scene.path, large.picture_switches(), version_of(settings.reference_program));
  // A float picture: 8 bits would round the very errors that are measured.
  const fs::path kept = cache_folder / "converged" / (key + ".exr");
  if (!fs::exists(kept)) {
    const ScratchFolder scratch;
    const RenderRun run = render(settings.reference_program, scene.path, scratch.path() / "large.exr", large);
    if (run.outcome != RenderOutcome::kRendered) {
      throw std::runtime_error("POV-Ray did not render " + scene.path.string() + ": " + name_of(run.outcome));
    }
    write_picture(reduced(read_picture(run.picture), settings.width, settings.height), kept);
  }
  return read_picture(kept);
}

Sweep run_sweep(const SceneFile& scene, const SweepSettings& settings, const fs::path& cache_folder) {
  std::string files = scene.name;
  std::replace(files.begin(), files.end(), '/', '_');
  Sweep sweep{scene, {}, settings.output / (files + ".converged.png")};
  const Picture converged = converged_picture(scene, settings, cache_folder);
  write_picture(converged, sweep.converged);
  for (std::size_t i = 0; i < settings.variations.size(); ++i) {
    for (const char* program : {"lute", "POV-Ray"}) {
      SweepPoint point;
      point.program = program;
      // lute's own: POV-Ray would take it for method 2.
      if (method_of(settings.variations[i]) == "method 3" && point.program != "lute") continue;
      point.setting = settings.variations[i];
      point.method = method_of(point.setting);
      point.picture = settings.output / (files + "." + program + "." + std::to_string(i) + ".png");
      sweep.points.push_back(std::move(point));
    }
  }
  // The programs take turns, so that a noisy machine hurts both alike.
  std::vector<std::vector<double>> cpu(sweep.points.size()), wall(sweep.points.size());
  for (int run = 0; run < settings.runs; ++run) {
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
      SweepPoint& point = sweep.points[i];
      const std::string& program = point.program == "lute" ? settings.lute_program : settings.reference_program;
      if (run == 0 || point.rendered) run_point(point, program, scene, settings, cpu[i], wall[i]);
    }
  }
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    SweepPoint& point = sweep.points[i];
    if (!point.rendered) continue;
    point.cpu = median(cpu[i]);
    point.wall = median(wall[i]);
    measure_error(point, converged);
  }
  mark_pareto_front(sweep.points);
  return sweep;
}

void write_csv(std::ostream& out, const std::vector<Sweep>& sweeps) {
  out << "scene,program,switches,method,rendered,cpu,wall,rmse,within_2_255,pareto\n";
  for (const Sweep& sweep : sweeps) {
    for (const SweepPoint& point : sweep.points) {
      char figures[120];
      std::snprintf(figures, sizeof figures, "%d,%.4f,%.4f,%.6f,%.5f,%d", point.rendered, point.cpu, point.wall,
                    point.rmse, point.within, point.pareto);
      out << csv_field(sweep.scene.name) << ',' << point.program << ',' << csv_field(point.setting) << ',' << point.method << ','
          << figures << '\n';
    }
  }
}

std::string SweepCircumstances::text() const {
  return machine + ", " + size + " pixels, one thread, medians of " + std::to_string(runs) + (runs == 1 ? " run" : " runs") + ". " +
         lute_version + ", " + reference_version + ".";
}

nlohmann::json to_json(const std::vector<Sweep>& sweeps, const SweepCircumstances& circumstances) {
  nlohmann::json scenes = nlohmann::json::array();
  for (const Sweep& sweep : sweeps) {
    nlohmann::json points = nlohmann::json::array();
    for (const SweepPoint& p : sweep.points) {
      points.push_back({{"program", p.program},
                        {"switches", p.setting},
                        {"method", p.method},
                        {"rendered", p.rendered},
                        {"failure", p.failure},
                        {"cpu", p.cpu},
                        {"wall", p.wall},
                        {"rmse", p.rmse},
                        {"within", p.within},
                        {"pareto", p.pareto}});
    }
    nlohmann::json pairs = nlohmann::json::array();
    for (const EqualError& pair : at_equal_error(sweep)) {
      pairs.push_back({{"switches", pair.setting},
                       {"rmse", pair.rmse},
                       {"reference_cpu", pair.reference_cpu},
                       {"own_cpu", pair.own_cpu}});
    }
    scenes.push_back({{"scene", sweep.scene.name}, {"points", points}, {"at_equal_error", pairs}});
  }
  return {{"machine", circumstances.machine},
          {"size", circumstances.size},
          {"runs", circumstances.runs},
          {"lute", circumstances.lute_version},
          {"reference", circumstances.reference_version},
          {"scenes", scenes}};
}

SweepCircumstances circumstances_of(const nlohmann::json& report) {
  return {report.at("machine"), report.at("size"), report.at("runs"), report.at("lute"), report.at("reference")};
}

std::vector<Sweep> from_json(const nlohmann::json& report) {
  std::vector<Sweep> sweeps;
  for (const nlohmann::json& scene : report.at("scenes")) {
    Sweep sweep;
    sweep.scene.name = scene.at("scene");
    for (const nlohmann::json& p : scene.at("points")) {
      sweep.points.push_back({p.at("program"), p.at("switches"), p.at("method"), p.at("rendered"), p.at("failure"), p.at("cpu"),
                              p.at("wall"), p.at("rmse"), p.at("within"), p.at("pareto"), {}, {}});
    }
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

}  // namespace lute::compare
