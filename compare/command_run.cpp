#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>

#include "compare/command.hpp"
#include "compare/report.hpp"
#include "compare/run_options.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {
namespace fs = std::filesystem;

void write_reports(const std::vector<SceneComparison>& comparisons, const ReportContext& context,
                   const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream csv(folder / "report.csv");
  write_csv(csv, comparisons);
  std::ofstream(folder / "report.json")
      << to_json(comparisons, context).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  std::ofstream html(folder / "report.html");
  write_html(html, comparisons, context);
}

void add_run_options(CLI::App& command, RunOptions& options) {
  command.add_option("--size", options.size, "Width and height of the pictures");
  command.add_option("--filter", options.filter, "Only scenes whose name has this regular expression");
  command.add_option("--sample", options.sample, "Only one scene of so many, always the same ones")
      ->check(CLI::Range(1, 1000));
  command.add_option("--jobs", options.jobs, "Scenes rendered at the same time")->check(CLI::Range(1, 256));
  command.add_option("--output", options.output, "Folder for pictures and reports");
  command.add_option("--lute", options.lute, "The lute program");
  command.add_option("--povray", options.povray, "The reference program");
  command.add_option("--timeout", options.time_limit, "Seconds that a program may need for one scene");
  command.add_option("--memory", options.memory_gib, "GiB of address space that a program may use");
  command.add_option("--switch", options.switches, "Switches for both programs instead of -A +WT1")
      ->allow_extra_args(false);
  command.add_option("--noise", options.noise, "Table of scenes that the reference renders differently each time");
  command.add_flag("--measure-again", options.measure_again,
                   "Render the reference even when it is cached, for undisturbed times");
}

ComparisonSettings settings_of(const RunOptions& options) {
  ComparisonSettings settings;
  parse_size(options.size, settings.lute.width, settings.lute.height);
  settings.lute.time_limit = options.time_limit;
  settings.lute.memory_limit = static_cast<std::uint64_t>(options.memory_gib * 1073741824.0);
  if (!options.switches.empty()) settings.lute.switches = options.switches;
  settings.reference = settings.lute;
  settings.lute_program = options.lute;
  settings.output = options.output;
  settings.measure_again = options.measure_again;
  return settings;
}

std::vector<SceneComparison> run_scenes(const RunOptions& options, const std::vector<std::string>& arguments,
                                        ReportContext& context) {
  const std::vector<SceneFile> scenes = sample_scenes(find_scenes(arguments, options.filter), options.sample);
  if (scenes.empty()) throw std::runtime_error("no scene to render");
  const ReferenceCache cache(ReferenceCache::default_folder(), options.povray);
  const ReferenceNoiseTable noise =
      fs::exists(options.noise) ? ReferenceNoiseTable(options.noise) : ReferenceNoiseTable();
  const ComparisonSettings settings = settings_of(options);

  context.reference_version = cache.version();
  context.lute_version = version_of(options.lute);
  context.machine = machine_description();
  for (const std::string& item : settings.lute.picture_switches()) context.switches += item + " ";

  if (!options.quiet) std::cout << kTableHead;
  auto comparisons =
      compare_scenes(scenes, cache, noise, settings, options.jobs, [&](const SceneComparison& comparison) {
        if (!options.quiet) write_table_row(std::cout, comparison);
      });
  if (!options.quiet) write_summary(std::cout, comparisons);
  write_reports(comparisons, context, options.output);
  return comparisons;
}

namespace {

struct RunCommandOptions : RunOptions {
  std::vector<std::string> arguments;
  bool csv = false, json = false;
};

int run_command(RunCommandOptions& options) {
  options.quiet = options.csv || options.json;
  ReportContext context;
  const std::vector<SceneComparison> comparisons = run_scenes(options, options.arguments, context);
  if (options.csv) write_csv(std::cout, comparisons);
  if (options.json) {
    std::cout << to_json(comparisons, context).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  }
  if (!options.quiet) std::cout << "report: " << (fs::path(options.output) / "report.html").string() << '\n';
  const bool good = std::all_of(comparisons.begin(), comparisons.end(), [](const auto& c) { return is_good(c.state); });
  return good ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunCommandOptions>();
  options->lute = default_lute_program();
  CLI::App* command = app.add_subcommand("run", "Render scenes with lute and with POV-Ray and compare the pictures");
  command->add_option("scenes", options->arguments, "Scene files, or folders with scenes")->required();
  add_run_options(*command, *options);
  command->add_flag("--csv", options->csv, "Print CSV instead of the table");
  command->add_flag("--json", options->json, "Print JSON instead of the table");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace lute::compare
