#include <iostream>
#include <memory>
#include <sstream>

#include "compare/command.hpp"
#include "compare/page_section.hpp"
#include "compare/sample_counts.hpp"

namespace lute::compare {

namespace {

struct SamplesOptions {
  std::vector<std::string> scenes, variations;
  std::string size = "160x120", into, lute, povray = "povray";
  double time_limit = 120;
};

int run_samples(const SamplesOptions& options) {
  RenderSettings settings;
  parse_size(options.size, settings.width, settings.height);
  settings.time_limit = options.time_limit;
  std::vector<SampleCount> counts;
  bool all_pass = true;
  for (const SceneFile& scene : find_scenes(options.scenes)) {
    for (const std::string& switches : options.variations) {
      counts.push_back(count_samples(scene, switches, settings, options.lute, options.povray));
      all_pass = all_pass && counts.back().passes();
    }
  }
  std::ostringstream section;
  write_markdown(section, counts, options.size + " pixels, " + version_of(options.lute) + ", " + version_of(options.povray) + ".");
  if (options.into.empty()) {
    std::cout << section.str();
  } else {
    replace_section(options.into, "samples", section.str());
  }
  return all_pass ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_samples_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SamplesOptions>();
  options->lute = default_lute_program();
  options->variations = {"+A0.3", "+AM2 +A0.1 +R3"};
  CLI::App* command = app.add_subcommand("samples", "Samples a pixel that antialiasing takes, beside POV-Ray's");
  command->add_option("scenes", options->scenes, "Scene files, or folders with scenes")->required();
  command->add_option("--vary", options->variations, "Groups of switches, each with every scene");
  command->add_option("--size", options->size, "Width and height of the pictures");
  command->add_option("--into", options->into, "Replace the table in this page instead of printing it");
  command->add_option("--lute", options->lute, "The lute program");
  command->add_option("--povray", options->povray, "The reference program");
  command->add_option("--timeout", options->time_limit, "Seconds that one run may take");
  command->callback([options, &exit_code] { exit_code = run_samples(*options); });
}

}  // namespace lute::compare
