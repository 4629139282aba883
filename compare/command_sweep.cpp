#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "compare/command.hpp"
#include "compare/page_section.hpp"
#include "compare/reference_cache.hpp"
#include "compare/report.hpp"
#include "compare/sweep.hpp"
#include "compare/sweep_chart.hpp"
#include "compare/sweep_summary.hpp"

namespace lute::compare {

namespace {

struct SweepOptions : SweepSettings {
  std::vector<std::string> scenes;
  std::string size = "160x120";
  std::string folder = "lute-sweep";
  std::string from, into, section = "sweep";
};

constexpr const char* kDefaultVariations[] = {"-A",
                                              "+A0.3",
                                              "+A0.1",
                                              "+A0.03 +R4",
                                              "+AM2 +A0.3 +R2",
                                              "+AM2 +A0.3",
                                              "+AM2 +A0.1 +R3",
                                              "+AM2 +A0.05 +R4",
                                              "+AM3 +AE0.08",
                                              "+AM3 +AE0.04",
                                              "+AM3 +AE0.02",
                                              "+AM3",
                                              "+AM3 +AE0.005"};

struct SweepReport {
  std::vector<Sweep> sweeps;
  SweepCircumstances circumstances;
};

void write_reports(const SweepReport& report, const std::filesystem::path& folder) {
  std::ofstream csv(folder / "sweep.csv"), html(folder / "sweep.html");
  write_csv(csv, report.sweeps);
  std::ofstream(folder / "sweep.json") << to_json(report.sweeps, report.circumstances).dump(1) << '\n';
  write_html(html, report.sweeps, report.circumstances.text());
  std::ofstream chart(folder / (std::filesystem::path(report.sweeps.back().scene.name).filename().string() + ".svg"));
  write_chart(chart, report.sweeps.back());
}

// Scenes of one name in several folders have their folders in the name, so that their pictures are kept apart.
std::vector<SceneFile> scenes_of(const SweepOptions& options) {
  std::vector<SceneFile> scenes = find_scenes(options.scenes);
  const auto same = [&](const SceneFile& scene) {
    return std::count_if(scenes.begin(), scenes.end(), [&](const SceneFile& other) { return other.name == scene.name; });
  };
  std::vector<SceneFile> result;
  for (const SceneFile& scene : scenes) result.push_back({scene.path, same(scene) == 1 ? scene.name : scene.path.generic_string()});
  return result;
}

SweepReport measured(SweepOptions& options) {
  parse_size(options.size, options.width, options.height);
  options.output = options.folder;
  if (options.variations.empty()) options.variations.assign(std::begin(kDefaultVariations), std::end(kDefaultVariations));
  SweepReport report;
  report.circumstances = {machine_description(), options.size, options.runs, version_of(options.lute_program),
                          version_of(options.reference_program)};
  for (const SceneFile& scene : scenes_of(options)) {
    report.sweeps.push_back(run_sweep(scene, options, ReferenceCache::default_folder().parent_path()));
    write_csv(std::cout, {report.sweeps.back()});
    write_reports(report, options.output);
  }
  std::cout << summary(report.sweeps) << "\nreport: " << (options.output / "sweep.html").string() << '\n';
  return report;
}

SweepReport read_report(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  const nlohmann::json report = nlohmann::json::parse(in);
  return {from_json(report), circumstances_of(report)};
}

// Names every point without a picture; true if lute has none at all of some scene.
bool tell_failures(const std::vector<Sweep>& sweeps) {
  bool nothing = sweeps.empty();
  for (const Sweep& sweep : sweeps) {
    bool any = false;
    for (const SweepPoint& point : sweep.points) {
      any = any || (point.rendered && point.program == "lute");
      if (!point.rendered) {
        std::cerr << sweep.scene.name << ", " << point.program << " " << point.setting << ": " << point.failure << '\n';
      }
    }
    nothing = nothing || !any;
  }
  return nothing;
}

int run_command(SweepOptions& options) {
  const SweepReport report = options.from.empty() ? measured(options) : read_report(options.from);
  const bool failed = tell_failures(report.sweeps);
  if (!options.into.empty()) {
    std::ostringstream section;
    // Without a comparison at equal error the points themselves are the table.
    (summary(report.sweeps).empty() ? write_points : write_markdown)(section, report.sweeps, report.circumstances.text());
    replace_section(options.into, options.section, section.str());
  }
  return failed ? kExitDiffers : kExitMatch;
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SweepOptions>();
  options->lute_program = default_lute_program();
  CLI::App* command = app.add_subcommand("sweep", "Error against run time of both programs, for a range of settings");
  auto* scenes = command->add_option("scenes", options->scenes, "Scene files, or folders with scenes");
  auto* from = command->add_option("--from", options->from, "Take the figures from this sweep.json instead of rendering");
  scenes->excludes(from);
  command->add_option("--into", options->into, "Replace the table in this page");
  command->add_option("--section", options->section, "Name of the table's marks in the page");
  command->add_option("--vary", options->variations,
                      "Groups of switches, each one point of the chart (--vary=-A for one that starts with -)");
  command->add_option("--size", options->size, "Width and height of the pictures");
  command->add_option("--runs", options->runs, "Runs of each point, of which the median counts")
      ->check(CLI::Range(1, 99));
  command->add_option("--output", options->folder, "Folder for pictures and reports");
  command->add_option("--lute", options->lute_program, "The lute program");
  command->add_option("--povray", options->reference_program, "The reference program");
  command->add_option("--timeout", options->time_limit, "Seconds that one run may take");
  command->callback([options, &exit_code] {
    if (options->scenes.empty() && options->from.empty()) throw CLI::RequiredError("scenes or --from");
    exit_code = run_command(*options);
  });
}

}  // namespace lute::compare
