#include <iostream>
#include <memory>

#include "compare/command.hpp"
#include "compare/large_scenes.hpp"
#include "compare/parse_time.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {

namespace {

struct ParseCommandOptions : ParseTimeSettings {
  std::vector<std::string> scenes;
  std::string filter;
  std::int64_t loop_turns = 10'000'000, mesh_faces = 1'000'000;
  bool no_large = false;
};

void add_time(std::vector<ParseTime>& times, const SceneFile& scene, const ParseTimeSettings& settings) {
  times.push_back(measure_parse_time(scene, settings));
  std::cerr << times.back().name << '\n';
}

int run_command(const ParseCommandOptions& options) {
  std::vector<ParseTime> times, large;
  if (!options.scenes.empty()) {
    for (const SceneFile& scene : find_scenes(options.scenes, options.filter)) {
      if (scene.path.extension() == ".pov") add_time(times, scene, options);
    }
  }
  if (!options.no_large) {
    const ScratchFolder folder;
    write_loop(folder.path() / "loop.pov", options.loop_turns);
    add_time(large, {folder.path() / "loop.pov", "loop of " + std::to_string(options.loop_turns) + " turns"}, options);
    std::filesystem::remove(folder.path() / "loop.pov");
    write_mesh(folder.path() / "mesh.pov", options.mesh_faces);
    const std::uintmax_t megabytes = std::filesystem::file_size(folder.path() / "mesh.pov") >> 20;
    add_time(large, {folder.path() / "mesh.pov", "mesh2 of " + std::to_string(options.mesh_faces) + " faces, " +
                                                     std::to_string(megabytes) + " MB"}, options);
  }
  if (!times.empty()) {
    write_table(std::cout, times);
    std::cout << "\ngeometric mean of the ratios: " << mean_ratio(times) << "\n\n";
  }
  if (!large.empty()) write_table(std::cout, large);
  return kExitMatch;
}

}  // namespace

void add_parse_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ParseCommandOptions>();
  options->lute_program = default_lute_program();
  CLI::App* command = app.add_subcommand("parse", "Time and memory that both programs take to read scenes");
  command->add_option("scenes", options->scenes, "Scene files, or folders with scenes");
  command->add_option("--filter", options->filter, "Regular expression searched in the scenes' names");
  command->add_option("--runs", options->runs, "Runs of each, of which the fastest counts")->check(CLI::Range(1, 99));
  command->add_option("--turns", options->loop_turns, "Turns of the loop that is generated");
  command->add_option("--faces", options->mesh_faces, "Faces of the mesh2 that is generated");
  command->add_flag("--no-large", options->no_large, "Leave the generated scenes out");
  command->add_option("--lute", options->lute_program, "The lute program");
  command->add_option("--povray", options->reference_program, "The reference program");
  command->add_option("--timeout", options->time_limit, "Seconds that one run may take");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace lute::compare
