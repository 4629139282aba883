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
  std::string from, into;
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

void write_reports(const std::vector<Sweep>& sweeps, const std::filesystem::path& folder) {
  const std::string machine = machine_description();
  std::ofstream csv(folder / "sweep.csv"), html(folder / "sweep.html");
  write_csv(csv, sweeps);
  std::ofstream(folder / "sweep.json") << to_json(sweeps, machine).dump(1) << '\n';
  write_html(html, sweeps, machine);
  std::ofstream chart(folder / (sweeps.back().scene.name + ".svg"));
  write_chart(chart, sweeps.back());
}

std::vector<Sweep> measured(SweepOptions& options) {
  parse_size(options.size, options.width, options.height);
  options.output = options.folder;
  if (options.variations.empty()) options.variations.assign(std::begin(kDefaultVariations), std::end(kDefaultVariations));
  std::vector<Sweep> sweeps;
  for (const SceneFile& scene : find_scenes(options.scenes)) {
    sweeps.push_back(run_sweep(scene, options, ReferenceCache::default_folder().parent_path()));
    write_csv(std::cout, {sweeps.back()});
    write_reports(sweeps, options.output);
  }
  std::cout << summary(sweeps) << "\nreport: " << (options.output / "sweep.html").string() << '\n';
  return sweeps;
}

int run_command(SweepOptions& options) {
  std::vector<Sweep> sweeps;
  std::string machine = machine_description();
  if (options.from.empty()) {
    sweeps = measured(options);
  } else {
    std::ifstream in(options.from);
    if (!in) throw std::runtime_error("cannot read " + options.from);
    const nlohmann::json report = nlohmann::json::parse(in);
    sweeps = from_json(report);
    machine = report.at("machine");
  }
  if (!options.into.empty()) {
    std::ostringstream section;
    write_markdown(section, sweeps, machine + ", " + options.size + " pixels, one thread.");
    replace_section(options.into, "sweep", section.str());
  }
  return kExitMatch;
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
