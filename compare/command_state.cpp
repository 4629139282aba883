#include <filesystem>
#include <iostream>
#include <memory>

#include "compare/command.hpp"
#include "compare/run_options.hpp"
#include "compare/state_table.hpp"

namespace lute::compare {

namespace {

constexpr const char* kExampleScenes = "/usr/share/doc/povray/examples";

struct StateOptions : RunOptions {
  std::string scenes = kExampleScenes;
  std::string table = LUTE_STATE_TABLE;
  bool update = false;
};

void print_changes(const char* heading, const std::vector<StateChange>& changes) {
  for (const StateChange& change : changes) {
    std::cout << heading << ": " << change.scene << ": " << (change.before ? name_of(*change.before) : "new") << " -> "
              << name_of(change.after) << '\n';
  }
}

int run_state(const StateOptions& options) {
  StateTable table;
  if (!options.update || std::filesystem::exists(options.table)) table = read_states(options.table);
  ReportContext context;
  context.title = "Conformance with POV-Ray";
  const std::vector<SceneComparison> comparisons = run_scenes(options, {options.scenes}, context);
  const std::vector<StateChange> worse = worsened(table, comparisons);
  print_changes("worse", worse);
  print_changes("better", improved(table, comparisons));
  const bool whole = options.filter.empty() && options.sample == 1;
  const std::vector<std::string> lost = whole ? missing(table, comparisons) : std::vector<std::string>{};
  for (const std::string& scene : lost) std::cout << "missing: " << scene << '\n';
  if (options.update) {
    improve(table, comparisons);
    write_states(table, options.table);
  }
  return worse.empty() && lost.empty() ? kExitMatch : kExitDiffers;
}

}  // namespace

void add_state_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<StateOptions>();
  options->lute = default_lute_program();
  options->output = "lute-conformance";
  CLI::App* command =
      app.add_subcommand("state", "Compare the example scenes with the conformance table; 1 if one got worse or is missing");
  command->add_option("scenes", options->scenes, "Folder of the scenes");
  command->add_option("--table", options->table, "The table of states");
  command->add_flag("--update", options->update, "Write better states to the table; worse ones never");
  add_run_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run_state(*options); });
}

}  // namespace lute::compare
