#include <fstream>
#include <iostream>
#include <memory>

#include "compare/command.hpp"
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
};

void write_reports(const std::vector<Sweep>& sweeps, const std::filesystem::path& folder) {
  const std::string machine = machine_description();
  std::ofstream csv(folder / "sweep.csv"), html(folder / "sweep.html");
  write_csv(csv, sweeps);
  std::ofstream(folder / "sweep.json") << to_json(sweeps, machine).dump(1) << '\n';
  write_html(html, sweeps, machine);
  std::ofstream chart(folder / (sweeps.back().scene.name + ".svg"));
  write_chart(chart, sweeps.back());
}

int run_command(SweepOptions& options) {
  parse_size(options.size, options.width, options.height);
  options.output = options.folder;
  if (options.variations.empty()) {
    options.variations = {"-A",          "+A0.3",       "+A0.1",      "+A0.03 +R4",      "+AM2 +A0.3 +R2", "+AM2 +A0.3",
                          "+AM2 +A0.1 +R3", "+AM2 +A0.05 +R4", "+AM3 +AE0.08", "+AM3 +AE0.04", "+AM3 +AE0.02",
                          "+AM3",        "+AM3 +AE0.005"};
  }
  std::vector<Sweep> sweeps;
  for (const SceneFile& scene : find_scenes(options.scenes)) {
    sweeps.push_back(run_sweep(scene, options, ReferenceCache::default_folder().parent_path()));
    write_csv(std::cout, {sweeps.back()});
    write_reports(sweeps, options.output);
  }
  std::cout << summary(sweeps) << "\nreport: " << (options.output / "sweep.html").string() << '\n';
  return kExitMatch;
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SweepOptions>();
  options->lute_program = default_lute_program();
  CLI::App* command = app.add_subcommand("sweep", "Error against run time of both programs, for a range of settings");
  command->add_option("scenes", options->scenes, "Scene files, or folders with scenes")->required();
  command->add_option("--vary", options->variations,
                      "Groups of switches, each one point of the chart (--vary=-A for one that starts with -)");
  command->add_option("--size", options->size, "Width and height of the pictures");
  command->add_option("--runs", options->runs, "Runs of each point, of which the median counts")
      ->check(CLI::Range(1, 99));
  command->add_option("--output", options->folder, "Folder for pictures and reports");
  command->add_option("--lute", options->lute_program, "The lute program");
  command->add_option("--povray", options->reference_program, "The reference program");
  command->add_option("--timeout", options->time_limit, "Seconds that one run may take");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace lute::compare
