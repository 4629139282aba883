#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "compare/command.hpp"
#include "compare/large_scenes.hpp"
#include "compare/page_section.hpp"
#include "compare/parse_time.hpp"
#include "compare/report.hpp"
#include "compare/scratch_folder.hpp"

namespace lute::compare {

namespace {

struct ParseCommandOptions : ParseTimeSettings {
  std::vector<std::string> scenes;
  std::string filter, into;
  std::int64_t loop_turns = 10'000'000, mesh_faces = 1'000'000;
  bool no_large = false;
};

void add_time(std::vector<ParseTime>& times, const SceneFile& scene, const ParseTimeSettings& settings) {
  times.push_back(measure_parse_time(scene, settings));
  std::cerr << times.back().name << '\n';
}

void measure_large(std::vector<ParseTime>& times, const ParseCommandOptions& options) {
  const ScratchFolder folder;
  const std::filesystem::path loop = folder.path() / "loop.pov", mesh = folder.path() / "mesh.pov";
  write_loop(loop, options.loop_turns);
  add_time(times, {loop, "loop of " + std::to_string(options.loop_turns) + " turns, three statements"}, options);
  std::filesystem::remove(loop);
  write_mesh(mesh, options.mesh_faces);
  const std::uintmax_t megabytes = std::filesystem::file_size(mesh) >> 20;
  add_time(times, {mesh, "mesh2 of " + std::to_string(options.mesh_faces) + " faces, " + std::to_string(megabytes) + " MB of text"}, options);
}

void write_scenes(std::ostream& out, const std::vector<ParseTime>& times) {
  const auto compared = std::ranges::count_if(times, &ParseTime::comparable);
  const auto rejected = std::ranges::count_if(times, &ParseTime::rejected);
  const auto same = std::ranges::count_if(
      times, [](const ParseTime& time) { return time.rejected() && time.lute_error == time.reference_error; });
  const auto wrongly = std::ranges::count_if(times, [](const ParseTime& time) { return !time.rejected() && !time.lute_error.empty(); });
  out << compared << " scenes that both read: geometric mean of the ratios **" << mean_ratio(times) << "** (of user time alone "
      << mean_ratio(times, &ParseTime::user_ratio) << ").\n"
      << rejected << " scenes that POV-Ray rejects: lute rejects " << same << " at the same file and line; scenes that lute alone rejects: "
      << wrongly << ".\n\n";
  write_rejections(out, times);
  out << "\n";
  write_times(out, times, false);
}

int run_command(const ParseCommandOptions& options) {
  std::vector<ParseTime> times, large;
  for (const SceneFile& scene : options.scenes.empty() ? std::vector<SceneFile>{} : find_scenes(options.scenes, options.filter)) {
    if (scene.path.extension() == ".pov") add_time(times, scene, options);
  }
  if (!options.no_large) measure_large(large, options);
  std::ostringstream out;
  out << machine_description() << "; processor time of the whole process, start-up included, the fastest of " << options.runs << ".\n\n";
  if (!large.empty()) write_times(out, large, true);
  if (!large.empty() && !times.empty()) out << "\n";
  if (!times.empty()) write_scenes(out, times);
  if (options.into.empty()) std::cout << out.str();
  else replace_section(options.into, "parse", out.str());
  const auto same = [](const ParseTime& time) { return time.lute_error == time.reference_error; };
  return std::ranges::all_of(times, same) ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_parse_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ParseCommandOptions>();
  options->lute_program = default_lute_program();
  CLI::App* command = app.add_subcommand("parse", "Time and memory that both programs take to read scenes, and where they reject them");
  command->add_option("scenes", options->scenes, "Scene files, or folders with scenes");
  command->add_option("--filter", options->filter, "Regular expression searched in the scenes' names");
  command->add_option("--runs", options->runs, "Runs of each, in turn, of which the fastest counts")->check(CLI::Range(1, 99));
  command->add_option("--turns", options->loop_turns, "Turns of the loop that is generated");
  command->add_option("--faces", options->mesh_faces, "Faces of the mesh2 that is generated");
  command->add_flag("--no-large", options->no_large, "Leave the generated scenes out");
  command->add_option("--into", options->into, "Replace the section of this page instead of printing it");
  command->add_option("--lute", options->lute_program, "The lute program");
  command->add_option("--povray", options->reference_program, "The reference program");
  command->add_option("--timeout", options->time_limit, "Seconds that one run may take");
  command->callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace lute::compare
