#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "compare/command.hpp"
#include "compare/page_section.hpp"
#include "compare/run_options.hpp"
#include "compare/speed_table.hpp"

namespace lute::compare {

namespace {

struct SpeedOptions : RunOptions {
  std::vector<std::string> scenes;
  std::string from, into;
};

std::string circumstances(const ReportContext& context) {
  return context.machine + ", `" + context.switches.substr(0, context.switches.find_last_not_of(' ') + 1) + "`, " +
         context.lute_version + ", " + context.reference_version +
         "; processor time of the whole process, start-up included.";
}

std::string section(const SpeedOptions& options) {
  std::ostringstream out;
  if (!options.from.empty()) {
    std::ifstream report(options.from);
    if (!report) throw std::runtime_error("cannot read " + options.from);
    write_markdown(out, read_speed_table(report), machine_description() + "; processor time of the whole process, start-up included.");
    return out.str();
  }
  ReportContext context;
  const std::vector<SceneComparison> comparisons = run_scenes(options, options.scenes, context);
  write_markdown(out, speed_table(comparisons), circumstances(context));
  return out.str();
}

int run_speed(SpeedOptions& options) {
  options.quiet = options.into.empty();
  const std::string text = section(options);
  if (options.into.empty()) {
    std::cout << text;
    return kExitMatch;
  }
  replace_section(options.into, "speed", text);
  return kExitMatch;
}

}  // namespace

void add_speed_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SpeedOptions>();
  options->lute = default_lute_program();
  options->size = "640x480";
  options->output = "lute-speed";
  CLI::App* command = app.add_subcommand("speed", "Processor time beside POV-Ray's, scene by scene, as a table in Markdown");
  auto* scenes = command->add_option("scenes", options->scenes, "Scene files, or folders with scenes");
  auto* from = command->add_option("--from", options->from, "Take the times from this report.csv instead of rendering");
  scenes->excludes(from);
  command->add_option("--into", options->into, "Replace the table in this page instead of printing it");
  add_run_options(*command, *options);
  command->callback([options, &exit_code] {
    if (options->scenes.empty() && options->from.empty()) throw CLI::RequiredError("scenes or --from");
    exit_code = run_speed(*options);
  });
}

}  // namespace lute::compare
